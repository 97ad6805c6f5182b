#include "reflect/resolve/screen_resolve.hpp"

#include <algorithm>

namespace glint::reflect {
namespace {

uint32_t maxTaps(const Settings& settings) {
    constexpr uint32_t kTaps[] = {9, 21, 41}; // 21: as in Babylon.js
    return kTaps[std::clamp(settings.blur.quality, 1, 3) - 1];
}

} // namespace

shared::BlurConstants blurConstants(const Settings& settings) {
    return {maxTaps(settings), settings.blur.strength, settings.rough.factor};
}

// ---------------------------------------------------------------- the stage

gpu::Image& ScreenResolve::record(gpu::Frame& frame, const ResolveInputs& inputs) {
    Signal signal = {&inputs.traced.target, inputs.traced.width, inputs.traced.height};
    if (stages_.plan.blur)
        signal = blur(frame, inputs, signal);
    if (stages_.plan.upsample)
        signal = upsample(frame, inputs, signal);
    return *(answer_ = signal.image);
}

void ScreenResolve::rehearse(gpu::Frame& frame, const ResolveInputs& inputs) {
    const Signal signal = {&inputs.traced.target, 1, 1};
    blur(frame, inputs, signal);
    upsample(frame, inputs, signal);
    answer_ = &inputs.traced.target;
}

// ---------------------------------------------------------------- blur

ScreenResolve::Signal ScreenResolve::blur(gpu::Frame& frame, const ResolveInputs& inputs, Signal source) {
    const uint32_t w = blurredPixels(stages_.settings(), source.width);
    const uint32_t h = blurredPixels(stages_.settings(), source.height);
    const bool whole = glm::uvec2(w, h) == stages_.extent; // then the second pass writes the answer
    const Signal last = {whole ? &whole_ : &blurred_[1], w, h};
    recordBlur(frame, inputs, false, source, {&blurred_[0], w, h});
    recordBlur(frame, inputs, true, {&blurred_[0], w, h}, last);
    return last;
}

void ScreenResolve::recordBlur(gpu::Frame& frame, const ResolveInputs& inputs, bool vertical, Signal source,
                               Signal target) {
    const shared::BlurPassConstants constants = {source.size(), target.size(), vertical};
    frame.pass(blurPass_)
        .read("frame", inputs.trace.frame.constants)
        .read("viewZ", inputs.trace.prepared.viewZ)
        .read("surface", inputs.trace.prepared.surface)
        .read("rayRecord", inputs.traced.rayRecord)
        .read("source", *source.image)
        .write("blurred", *target.image)
        .push(constants)
        .dispatch(target.width, target.height);
}

// ---------------------------------------------------------------- upsample

ScreenResolve::Signal ScreenResolve::upsample(gpu::Frame& frame, const ResolveInputs& inputs, Signal source) {
    gpu::Pass pass = frame.pass(upsamplePass_);
    readHitColor(pass, inputs.trace);
    pass.read("frame", inputs.trace.frame.constants)
        .read("viewZ", inputs.trace.prepared.viewZ)
        .read("surface", inputs.trace.prepared.surface)
        .read("rayRecord", inputs.traced.rayRecord)
        .read("traced", inputs.traced.target)
        .read("rayList", inputs.trace.rays.list)
        .read("source", *source.image)
        .write("radianceWeight", whole_)
        .push(source.size())
        .dispatch(stages_.extent.x, stages_.extent.y);
    return {&whole_, stages_.extent.x, stages_.extent.y};
}

// ---------------------------------------------------------------- creation

Result<std::unique_ptr<ScreenResolve>> ScreenResolve::create(StageContext& stages) {
    std::unique_ptr<ScreenResolve> stage(new ScreenResolve(stages));
    GLINT_TRY(blurPass, gpu::Pipeline::compute(stages.gpu, {"resolve/blur", sizeof(shared::BlurPassConstants), {}},
                                               gpu::Compile::Later));
    GLINT_TRY(upsamplePass,
              gpu::Pipeline::compute(stages.gpu, {"resolve/upsample", sizeof(glm::vec2), {}}, gpu::Compile::Later));
    stage->blurPass_ = std::move(blurPass);
    stage->upsamplePass_ = std::move(upsamplePass);
    return stage;
}

Result<void> ScreenResolve::make() {
    const FramePlan& plan = stages_.plan;
    const auto make = [&](gpu::Image& image, const char* name) {
        return makeImage(stages_.gpu, image, {name, VK_FORMAT_R16G16B16A16_SFLOAT, stages_.width(), stages_.height()});
    };
    if (plan.upsample || plan.blur)
        GLINT_CHECK(make(whole_, "glint/resolved"));
    if (plan.upsample)
        GLINT_CHECK(upsamplePass_.compile());
    if (!plan.blur)
        return {};
    GLINT_CHECK(blurPass_.compile());
    GLINT_CHECK(make(blurred_[0], "glint/blurredX"));
    return plan.upsample ? make(blurred_[1], "glint/blurred") : Result<void>();
}

} // namespace glint::reflect
