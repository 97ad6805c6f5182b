#include "reflect/trace/screen_trace.hpp"

namespace glint::reflect {

Result<std::unique_ptr<ScreenTrace>> ScreenTrace::create(StageContext& stages) {
    std::unique_ptr<ScreenTrace> trace(new ScreenTrace(stages));
    using gpu::Pipeline;
    GLINT_TRY(classify, Pipeline::compute(stages.gpu, {"trace/classify", 0, {}}, gpu::Compile::Later));
    trace->classify_ = std::move(classify);
    for (const Technique& technique : techniques()) {
        GLINT_TRY(marcher, Pipeline::compute(stages.gpu, {technique.shader, 0, {}}, gpu::Compile::Later));
        trace->marchers_.push_back(std::move(marcher));
    }
    const uint32_t w = stages.width();
    const uint32_t h = stages.height();
    GLINT_TRY(lister, RayLister::create(stages.gpu, w, h));
    trace->lister_ = std::move(lister);
    constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;
    constexpr VkFormat kByte = VK_FORMAT_R8G8B8A8_UNORM;
    GLINT_CHECK(makeImage(stages.gpu, trace->unused_, {"glint/unused", kHalf, 1, 1, kCleared}));
    GLINT_CHECK(makeImage(stages.gpu, trace->unused8_, {"glint/unused8", kByte, 1, 1, kCleared}));
    return trace;
}

gpu::Pipeline& ScreenTrace::marcherOf(const Settings& settings) {
    return marchers_[indexOf(techniqueFor(settings.screen.march))];
}

Result<void> ScreenTrace::make() {
    const Settings& settings = stages_.settings();
    const FramePlan& plan = stages_.plan;
    if (plan.screen)
        GLINT_CHECK(marcherOf(settings).compile());
    if (plan.screen && !plan.classifiesEarly)
        GLINT_CHECK(classify_.compile());
    const uint32_t w = tracedPixels(settings, stages_.width());
    const uint32_t h = tracedPixels(settings, stages_.height());
    const auto grow = [&](gpu::Image& image, const StageImage& wanted) -> Result<void> {
        GLINT_TRY(made, growImage(stages_, image, wanted));
        if (made)
            untraced_.ask();
        return {};
    };
    if (settings.screen.targetFormat == TargetFormat::Rgba8)
        GLINT_CHECK(grow(radianceWeight8_, {"glint/radianceWeight8", VK_FORMAT_R8G8B8A8_UNORM, w, h, kCleared}));
    else
        GLINT_CHECK(grow(radianceWeight_, {"glint/radianceWeight", VK_FORMAT_R16G16B16A16_SFLOAT, w, h, kCleared}));
    const bool keeps = plan.keepsRecord;
    GLINT_CHECK(grow(rayRecord_, {"glint/rayRecord", VK_FORMAT_R32G32_UINT, keeps ? w : 1, keeps ? h : 1, kCleared}));
    if (listed_.x >= w && listed_.y >= h)
        return {};
    GLINT_TRY(rays, RayLister::makeList(stages_.gpu, "glint/rays", w, h));
    stages_.retired.keep(std::move(rays_.list));
    rays_ = std::move(rays);
    listed_ = {w, h};
    return {};
}

void ScreenTrace::clear(gpu::Frame& frame) {
    if (frame.rehearsing() || !blank_.isNeeded(stages_.progress))
        return;
    frame.clear(unused_, {});
    frame.clear(unused8_, {});
    blank_.recorded(stages_.progress);
}

void ScreenTrace::begin(bool whole) {
    const bool eightBits = stages_.settings().screen.targetFormat == TargetFormat::Rgba8;
    if (eightBits != eightBits_)
        untraced_.ask();
    eightBits_ = eightBits;
    width_ = whole ? stages_.extent.x : tracedPixels(stages_.settings(), stages_.extent.x);
    height_ = whole ? stages_.extent.y : tracedPixels(stages_.settings(), stages_.extent.y);
}

void ScreenTrace::rehearse(gpu::Frame& frame, const TraceInputs& inputs, glm::uvec2 backFaceGroups) {
    classify(frame, inputs.frame, inputs.prepared);
    list(frame, backFaceGroups, false);
    for (const Technique& technique : techniques())
        recordMarch(frame, technique, marchers_[indexOf(technique)], inputs, target());
}

void ScreenTrace::beginClasses(gpu::Frame& frame) {
    untraced_.ask();
    lister_.begin(frame);
}

void ScreenTrace::classify(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared) {
    beginClasses(frame);
    gpu::Pass pass = frame.pass(classify_);
    pass.read("frame", inputs.constants).read("viewZ", prepared.viewZ).read("surface", prepared.surface);
    pass.read("rayRates", inputs.rayRates, kTexels).read("otherLobe", prepared.otherLobe);
    bindClasses(pass).dispatch(width_, height_);
}

void ScreenTrace::list(gpu::Frame& frame, glm::uvec2 backFaceGroups, bool always) {
    const glm::uvec2 pyramidGroups = (stages_.extent + shared::kPyramidTile - 1u) / shared::kPyramidTile;
    lister_.list(frame, rays_, width_, height_, {pyramidGroups, backFaceGroups, always});
}

Traced ScreenTrace::record(gpu::Frame& frame, const TraceInputs& inputs) {
    const Settings& settings = stages_.settings();
    recordMarch(frame, techniqueFor(settings.screen.march), marcherOf(settings), inputs, target());
    return traced();
}

Traced ScreenTrace::recordNothing(gpu::Frame& frame) {
    if (!frame.rehearsing() && untraced_.isNeeded(stages_.progress)) {
        frame.clear(traced().target, {});
        frame.clear(rayRecord_, {});
        untraced_.recorded(stages_.progress);
    }
    return traced();
}

Traced ScreenTrace::traced() {
    return {eightBits_ ? radianceWeight8_ : radianceWeight_, rayRecord_, width_, height_};
}

TraceTarget ScreenTrace::target() {
    return {eightBits_ ? unused_ : radianceWeight_, eightBits_ ? radianceWeight8_ : unused8_, rayRecord_};
}

} // namespace glint::reflect
