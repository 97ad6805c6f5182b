#include "reflect/trace/technique.hpp"

#include <algorithm>

namespace glint::reflect {

std::span<const Technique> techniques() {
    static const Technique kTechniques[] = {kLinearTechnique};
    return kTechniques;
}

gpu::Pass& readHitColor(gpu::Pass& pass, TraceInputs& inputs) {
    constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;
    const auto orBlack = [&](gpu::Image& image) -> gpu::Image& { return image ? image : inputs.black; };
    return pass.read("litRadiance", inputs.host.litRadiance, kTexels)
        .read("prevColor", inputs.history ? inputs.history->color : inputs.black, kTexels)
        .read("prevViewZ", inputs.history ? inputs.history->viewZ : inputs.black, kTexels)
        .read("motion", orBlack(inputs.host.motion), kTexels);
}

gpu::Pass& writeTraced(gpu::Pass& pass, Traced& out) {
    return pass.write("radianceWeight", out.eightBits ? out.unused : out.radianceWeight)
        .write("radianceWeight8", out.eightBits ? out.radianceWeight8 : out.unused8)
        .write("rayRecord", out.rayRecord);
}

shared::TraceConstants traceConstants(const Settings& settings) {
    shared::TraceConstants constants = {};
    constants.maxDistance = settings.screen.maxDistance;
    constants.thickness = settings.screen.thicknessMode == ThicknessMode::Constant ? settings.screen.thickness : 0;
    constants.thicknessRelative =
        settings.screen.thicknessMode == ThicknessMode::Relative ? settings.screen.thicknessRelative : 0;
    // With a blur, roughness widens that instead: jitter would only make it noisy.
    constants.roughnessFactor = settings.blur.strength > 0 ? 0 : settings.rough.factor;
    constants.maxSteps = static_cast<uint32_t>(settings.screen.maxSteps);
    constants.step = static_cast<uint32_t>(settings.screen.step);
    constants.selfCollisionSkip = static_cast<uint32_t>(settings.screen.selfCollisionSkip);
    constants.roughnessFadeStart = settings.reflect.roughnessFadeStart;
    constants.maxRoughness = settings.reflect.maxRoughness;
    constants.borderWidth = settings.fade.borderWidth;

    // Half a step of an 8-bit F0 on top, so that a threshold of 0.04 leaves out plain dielectrics however stored.
    constants.threshold = settings.reflect.threshold + 1.0f / 510.0f;
    if (settings.reflect.thresholdOn == ThresholdOn::F0TimesStrength)
        constants.threshold /= std::max(settings.reflect.strength, 1e-30f);
    if (settings.reflect.strength <= 0)
        constants.threshold = 2; // nothing is traced

    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    flag(settings.screen.smooth, shared::kTraceSmooth);
    flag(settings.screen.clipToFrustum, shared::kTraceClipToFrustum);
    flag(settings.fade.border == FadeBorder::Smooth, shared::kFadeBorderSmooth);
    flag(settings.fade.border == FadeBorder::Linear, shared::kFadeBorderLinear);
    flag(settings.fade.distance, shared::kFadeDistance);
    flag(settings.fade.iterations, shared::kFadeIterations);
    flag(settings.fade.facingCamera, shared::kFadeFacingCamera);
    flag(settings.fade.backface, shared::kFadeBackface);
    return constants;
}

} // namespace glint::reflect
