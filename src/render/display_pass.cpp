#include "render/display_pass.hpp"

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
    GLINT_TRY(pipeline, gpu::Pipeline::compute(context, {"display/tonemap", sizeof(shared::DisplayConstants), {}}));
    result.pipeline_ = std::move(pipeline);
    return result;
}

void DisplayPass::draw(gpu::Frame& frame, gpu::Image& hdr, gpu::Image& ldr, const DisplaySettings& settings) {
    const shared::DisplayConstants constants = {
        {ldr.width(), ldr.height()}, std::exp2(settings.exposure), tonemapCode(settings.tonemap)};
    frame.pass(pipeline_)
        .read("radiance", hdr, gpu::SamplerKind::NearestClamp)
        .write("display", ldr)
        .push(constants)
        .dispatch(ldr.width(), ldr.height());
}

} // namespace glint::render
