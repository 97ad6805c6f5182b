#include "lab/renderer/display_pass.hpp"

#include "shared/display.h"

#include <cmath>

namespace glint::render {
namespace {

uint32_t tonemapCode(Tonemap tonemap) {
    switch (tonemap) {
    case Tonemap::None: return shared::kTonemapNone;
    case Tonemap::Neutral: return shared::kTonemapNeutral;
    case Tonemap::Agx: return shared::kTonemapAgx;
    }
    return shared::kTonemapNone;
}

} // namespace

Result<DisplayPass> DisplayPass::create(gpu::Context& context) {
    DisplayPass result;
    GLINT_TRY(tonemap, gpu::Pipeline::compute(context, {"display/tonemap", sizeof(shared::DisplayConstants), {}}));
    GLINT_TRY(fxaa, gpu::Pipeline::compute(context, {"display/fxaa", sizeof(shared::FxaaConstants), {}}));
    result.tonemap_ = std::move(tonemap);
    result.fxaa_ = std::move(fxaa);
    return result;
}

Result<void> DisplayPass::resize(gpu::Context& context, uint32_t width, uint32_t height,
                                 const DisplaySettings& settings) {
    if (settings.antialias != Antialias::Fxaa || (aliased_ && aliased_.width() == width && aliased_.height() == height))
        return {};
    GLINT_TRY(aliased, gpu::Image::create(context, {"display/aliased", VK_FORMAT_R8G8B8A8_UNORM, width, height, 1, 1,
                                                    gpu::ImageShape::Flat,
                                                    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT}));
    aliased_ = std::move(aliased);
    return {};
}

void DisplayPass::draw(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr, const DisplaySettings& settings) {
    const bool smooth = settings.antialias == Antialias::Fxaa || frame.rehearsing();
    const shared::DisplayConstants constants = {
        {ldr.width(), ldr.height()}, std::exp2(settings.exposure), tonemapCode(settings.tonemap)};
    frame.pass(tonemap_)
        .read("radiance", hdr, gpu::SamplerKind::NearestClamp)
        .write("display", smooth ? aliased_ : ldr)
        .push(constants)
        .dispatch(ldr.width(), ldr.height());
    if (smooth)
        frame.pass(fxaa_)
            .read("aliased", aliased_)
            .write("display", ldr)
            .push(shared::FxaaConstants{{ldr.width(), ldr.height()}})
            .dispatch(ldr.width(), ldr.height());
}

} // namespace glint::render
