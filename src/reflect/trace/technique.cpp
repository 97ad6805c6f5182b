#include "reflect/trace/technique.hpp"

#include "base/assert.hpp"
#include "reflect/denoise/denoises.hpp"
#include "reflect/stage.hpp"
#include "reflect/trace/cone_picture.hpp"

#include <algorithm>

namespace glint::reflect {

/// As in compute_ssr: the longest rays have 2 * adaptive.steps, at most this many.
static constexpr uint32_t kMostAdaptiveSteps = 128;

std::span<const Technique> techniques() {
    static const Technique kTechniques[] = {kLinearTechnique, kAdaptiveTechnique, kHizTechnique, kProxyTechnique};
    return kTechniques;
}

const Technique& techniqueFor(March march) {
    const std::span<const Technique> all = techniques();
    const auto found = std::ranges::find(all, march, &Technique::march);
    GLINT_ASSERT(found != all.end(), "march {}", static_cast<int>(march));
    return *found;
}

std::string logShader(const Technique& technique) {
    std::string shader(technique.shader);
    return shader.insert(shader.rfind('/'), "/log");
}

gpu::Pass& readHitColor(gpu::Pass& pass, const TraceInputs& inputs) {
    Inputs& host = inputs.frame.host;
    gpu::Image& black = inputs.frame.standIns.black;
    return pass.read("litRadiance", host.litRadiance, kTexels)
        .read("metViewZ", inputs.met.viewZ)
        .read("metSurface", inputs.met.surface)
        .read("hitMaterial", inputs.prepared.material, kTexels)
        .read("prevColor", inputs.previous ? inputs.previous->color : black, kTexels)
        .read("prevViewZ", inputs.previous ? inputs.previous->viewZ : black, kTexels)
        .read("motion", host.motion ? host.motion : black, kTexels)
        .read("picture", inputs.conePicture ? *inputs.conePicture : black);
}

gpu::Pass& writeTraced(gpu::Pass& pass, TraceTarget out) {
    return pass.write("radianceWeight", out.radianceWeight)
        .write("radianceWeight8", out.radianceWeight8)
        .write("rayRecord", out.rayRecord);
}

gpu::Pass tracePass(gpu::Frame& frame, const gpu::Pipeline& pipeline, TraceInputs& inputs, TraceTarget out) {
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("frame", inputs.frame.constants)
        .read("rays", inputs.rays.list)
        .read("viewZ", inputs.prepared.viewZ)
        .read("backViewZ", inputs.met.backViewZ, kTexels)
        .read("surface", inputs.prepared.surface)
        .read("blueNoise", inputs.frame.standIns.blueNoise);
    readHitColor(pass, inputs);
    if (inputs.log)
        pass.readWrite("rayLog", *inputs.log);
    pass.readWrite("radianceWeight", out.radianceWeight) // the pass that classifies wrote the rest, if it is read
        .readWrite("radianceWeight8", out.radianceWeight8)
        .readWrite("rayRecord", out.rayRecord);
    return pass;
}

shared::TraceConstants traceConstants(const Settings& settings, bool backFacesKnown) {
    shared::TraceConstants constants = {};
    constants.maxDistance = settings.screen.maxDistance;
    const bool hiz = settings.screen.march == March::Hiz;
    constants.thickness = settings.screen.thicknessMode == ThicknessMode::Relative ? 0 : settings.screen.thickness;
    constants.thicknessRelative =
        settings.screen.thicknessMode == ThicknessMode::Relative ? settings.screen.thicknessRelative : 0;
    if (hiz)
        constants.thicknessRelative += settings.hiz.depthBias;
    // With a blur, roughness sets its width instead: jitter would only add noise.
    constants.roughnessFactor = settings.blur.strength > 0 || denoises(settings) ? 0 : settings.rough.factor;
    switch (settings.screen.march) {
    case March::Linear: constants.maxSteps = static_cast<uint32_t>(settings.screen.maxSteps); break;
    case March::Adaptive: constants.maxSteps = kMostAdaptiveSteps; break;
    case March::Hiz: constants.maxSteps = static_cast<uint32_t>(settings.hiz.maxIterations); break;
    case March::Proxy: constants.maxSteps = 1; break;
    }
    constants.baseSteps = static_cast<uint32_t>(settings.adaptive.steps);
    constants.pixelSpacing = settings.adaptive.pixelSpacing;
    constants.refinements = static_cast<uint32_t>(settings.adaptive.refinements);
    constants.inferredWeight = settings.screen.inferred;
    constants.step = static_cast<uint32_t>(settings.screen.step);
    constants.selfCollisionSkip = static_cast<uint32_t>(settings.screen.selfCollisionSkip);
    constants.roughnessFadeStart = settings.reflect.roughnessFadeStart;
    constants.maxRoughness = settings.reflect.maxRoughness;
    constants.borderWidth = settings.fade.borderWidth;
    constants.minLevel = static_cast<uint32_t>(settings.hiz.minLevel);
    constants.maxLevel = static_cast<uint32_t>(std::max(settings.hiz.minLevel, settings.hiz.maxLevel));

    // Half an 8-bit step more, so that a threshold of 0.04 rejects plain dielectrics in any format of F0.
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
    flag(denoises(settings), shared::kTraceLobe);
    flag(ConePicture::wanted(settings), shared::kTraceCones);
    flag(settings.screen.thicknessMode == ThicknessMode::Backface && backFacesKnown, shared::kTraceBackDepth);
    return constants;
}

} // namespace glint::reflect
