#include "lab/measure/bench/floor_pass.hpp"

namespace glint::measure {

Result<FloorPass> FloorPass::create(gpu::Context& context, uint32_t width, uint32_t height) {
    FloorPass pass;
    GLINT_TRY(pipeline, gpu::Pipeline::compute(context, {kName, 0, {}}));
    pass.pipeline_ = std::move(pipeline);
    GLINT_TRY(result, gpu::Image::create(context, {"measure/floor", VK_FORMAT_R16G16B16A16_SFLOAT, width, height, 1, 1,
                                                   gpu::ImageShape::Flat, VK_IMAGE_USAGE_STORAGE_BIT}));
    pass.result_ = std::move(result);
    return pass;
}

void FloorPass::record(gpu::Frame& frame, render::GBuffer& gbuffer) {
    if (gbuffer.deviceDepth.desc().samples > 1)
        return;
    constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;
    frame.pass(pipeline_)
        .read("depth", gbuffer.deviceDepth, kTexels)
        .read("normal", gbuffer.normal, kTexels)
        .read("material", gbuffer.material, kTexels)
        .read("litRadiance", gbuffer.litRadiance, kTexels)
        .write("result", result_)
        .dispatch(result_.width(), result_.height());
}

} // namespace glint::measure
