#include "lab/renderer/background_pass.hpp"

namespace glint::render {

Result<BackgroundPass> BackgroundPass::create(gpu::Context& context, const GBufferOptions& options) {
    BackgroundPass result;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/fullscreen.vert";
    desc.fragmentShader = "render/background.frag";
    desc.colorFormats = {kRadianceFormat};
    desc.depthFormat = kDepthFormat;
    desc.depthCompare = VK_COMPARE_OP_EQUAL; // the triangle has depth 0, infinitely far
    desc.depthWrite = false;
    desc.samples = options.samples;
    GLINT_TRY(radiance, gpu::Pipeline::raster(context, desc));
    desc.fragmentShader = "render/background_motion.frag";
    desc.colorFormats = {kMotionFormat};
    desc.samples = options.mode == GBufferMode::Prepass ? options.samples : 1;
    GLINT_TRY(motion, gpu::Pipeline::raster(context, desc));
    result.motion_ = std::move(motion);
    result.radiance_ = std::move(radiance);
    return result;
}

void BackgroundPass::draw(gpu::Frame& frame, gpu::Buffer& view, Environment& environment, GBuffer& gbuffer) {
    frame.pass(motion_)
        .read("view", view)
        .color(drawn(gbuffer.multisampled.motion, gbuffer.motion))
        .depth(gbuffer.deviceDepth, false, false)
        .draw([](gpu::Draws& draws) { draws.draw(3); });
    frame.pass(radiance_)
        .read("view", view)
        .read("environmentRadiance", environment.radiance())
        .color(drawn(gbuffer.multisampled.litRadiance, gbuffer.litRadiance))
        .depth(gbuffer.shadedDepth(), false, false)
        .draw([](gpu::Draws& draws) { draws.draw(3); });
}

} // namespace glint::render
