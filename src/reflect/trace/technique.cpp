#include "reflect/trace/technique.hpp"

#include <algorithm>

namespace glint::reflect {

std::span<const Technique> techniques() {
    static const Technique kTechniques[] = {kLinearTechnique};
    return kTechniques;
}

shared::TraceConstants traceConstants(const Settings& settings) {
    shared::TraceConstants constants = {};
    constants.maxDistance = settings.screen.maxDistance;
    constants.thickness = settings.screen.thicknessMode == ThicknessMode::Constant ? settings.screen.thickness : 0;
    constants.thicknessRelative =
        settings.screen.thicknessMode == ThicknessMode::Relative ? settings.screen.thicknessRelative : 0;
    constants.roughnessFactor = settings.rough.factor;
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
