#include "lab/measure/truth/share_pass.hpp"

namespace glint::measure {
namespace {

struct SharePush {
    float share;
    uint32_t tileSize; ///< pixels
};
constexpr uint32_t kTileSize = 16;

} // namespace

Result<SharePass> SharePass::create(gpu::Context& context) {
    gpu::RasterDesc desc;
    desc.vertexShader = "render/fullscreen.vert";
    desc.fragmentShader = "measure/share.frag";
    desc.pushSize = sizeof(SharePush);
    desc.colorFormats = {render::GBuffer::colorFormats(context)[1]};
    SharePass pass;
    GLINT_TRY(pipeline, gpu::Pipeline::raster(context, desc));
    pass.pipeline_ = std::move(pipeline);
    return pass;
}

void SharePass::record(gpu::Frame& frame, render::GBuffer& gbuffer, float share) {
    frame.pass(pipeline_)
        .read("depth", gbuffer.deviceDepth, gpu::SamplerKind::NearestClamp)
        .color(gbuffer.material)
        .draw([&](gpu::Draws& draws) {
            draws.push(SharePush{share, kTileSize});
            draws.draw(3);
        });
}

} // namespace glint::measure
