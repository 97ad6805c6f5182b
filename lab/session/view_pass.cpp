#include "lab/session/view_pass.hpp"

#include "base/assert.hpp"
#include "shared/display.h"

namespace glint::render {

static uint32_t viewKindCode(ViewKind kind) {
    switch (kind) {
    case ViewKind::Direction: return shared::kViewDirection;
    case ViewKind::Distance: return shared::kViewDistance;
    case ViewKind::Count: return shared::kViewCount;
    case ViewKind::Motion: return shared::kViewMotion;
    case ViewKind::Radiance:
    case ViewKind::Fraction: break;
    }
    return shared::kViewFraction;
}

Result<ViewPass> ViewPass::create(gpu::Context& context) {
    ViewPass result;
    GLINT_TRY(pipeline, gpu::Pipeline::compute(context, {"display/view", sizeof(shared::ViewConstants), {}}));
    result.pipeline_ = std::move(pipeline);
    return result;
}

void ViewPass::draw(gpu::Frame& frame, gpu::Image& values, ViewKind kind, gpu::Image& target) {
    GLINT_ASSERT(kind != ViewKind::Radiance, "radiance goes through the display pass, kind {}", static_cast<int>(kind));
    frame.pass(pipeline_)
        .read("values", values, gpu::SamplerKind::NearestClamp)
        .write("display", target)
        .push(shared::ViewConstants{{target.width(), target.height()}, viewKindCode(kind)})
        .dispatch(target.width(), target.height());
}

} // namespace glint::render
