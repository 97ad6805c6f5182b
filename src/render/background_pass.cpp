#include "render/background_pass.hpp"

namespace glint::render {

Result<BackgroundPass> BackgroundPass::create(gpu::Context& context) {
    BackgroundPass result;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/fullscreen.vert";
    desc.fragmentShader = "render/background.frag";
    desc.colorFormats = {kMotionFormat, kRadianceFormat};
    desc.depthFormat = kDepthFormat;
    desc.depthCompare = VK_COMPARE_OP_EQUAL; // the triangle lies at 0, infinitely far
    desc.depthWrite = false;
    GLINT_TRY(pipeline, gpu::Pipeline::raster(context, desc));
    result.pipeline_ = std::move(pipeline);
    return result;
}

void BackgroundPass::draw(gpu::Frame& frame, gpu::Buffer& view, Environment& environment, GBuffer& gbuffer) {
    frame.pass(pipeline_)
        .read("view", view)
        .read("environmentRadiance", environment.radiance())
        .color(gbuffer.motion)
        .color(gbuffer.litRadiance)
        .depth(gbuffer.deviceDepth, false, false)
        .draw([](gpu::Draws& draws) { draws.draw(3); });
}

} // namespace glint::render
