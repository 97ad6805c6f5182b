#include "reflect/trace/technique.hpp"

#include "base/assert.hpp"
#include "reflect/denoise/denoises.hpp"
#include "reflect/resolve/lobe_mean.hpp"
#include "reflect/stage.hpp"
#include "reflect/trace/cone_picture.hpp"

#include <algorithm>
#include <array>

namespace glint::reflect {
namespace {

uint32_t unsignedOf(int setting) {
    return static_cast<uint32_t>(setting);
}

/// As in compute_ssr: the longest rays have 2 * adaptive.steps, at most this many.
constexpr uint32_t kMostAdaptiveSteps = 128;

constexpr std::array kTechniques = {
    // One depth lookup every few pixels along the ray's line, but in open space. docs/techniques/linear.md
    Technique{.name = "linear",
              .march = March::Linear,
              .shader = "trace/linear",
              .usesPyramid = true,
              .canRunOut = true,
              .maxSteps = [](const Settings& s) { return unsignedOf(s.screen.maxSteps); },
              .maxLookups = // from 9 steps on it looks for open space: a cell before a sample
              [](const Settings& s) { return unsignedOf(s.screen.maxSteps) * (s.screen.maxSteps < 9 ? 1 : 2) + 1; }},
    // Equal steps on screen, then a binary search. docs/techniques/adaptive.md
    Technique{.name = "adaptive",
              .march = March::Adaptive,
              .shader = "trace/adaptive",
              .maxSteps = [](const Settings&) { return kMostAdaptiveSteps; },
              .maxLookups = // three searches: more surfaces in front of a hit are rare
              [](const Settings& s) {
                  const uint32_t steps = std::min(2 * unsignedOf(s.adaptive.steps), kMostAdaptiveSteps);
                  return steps + 3 * unsignedOf(s.adaptive.refinements) + 1;
              }},
    // Cell by cell through the depth pyramid. docs/techniques/hiz.md
    Technique{.name = "hiz",
              .march = March::Hiz,
              .shader = "trace/hiz",
              .usesPyramid = true,
              .canRunOut = true,
              .maxSteps = [](const Settings& s) { return unsignedOf(s.hiz.maxIterations); },
              .maxLookups = // a cell, the pixel of its flat surface, and the neighbour where the ray intersects that
              [](const Settings& s) { return 3 * unsignedOf(s.hiz.maxIterations) + 1; },
              .depthBias = [](const Settings& s) { return s.hiz.depthBias; }},
    // One lookup, at the hit that the pixel's probe volume predicts. docs/techniques/proxy.md
    Technique{.name = "proxy",
              .march = March::Proxy,
              .shader = "trace/proxy",
              .usesProbes = true,
              .walks = false,
              .maxSteps = [](const Settings&) { return 1u; },
              .maxLookups = [](const Settings&) { return 1u; }},
};

/// Binds what shaders/probes/probe_lists.glsl declares. An empty grid does not read the other two buffers.
gpu::Pass& bindLists(gpu::Pass& pass, TraceInputs& inputs) {
    if (inputs.probes)
        return inputs.probes->bindLists(pass);
    gpu::Buffer& none = inputs.frame.standIns.noProbes;
    return pass.read("probes", none).read("probeCells", none).read("probeLists", none);
}

void setThickness(const Settings& settings, shared::TraceConstants& constants) {
    const bool relative = settings.screen.thicknessMode == ThicknessMode::Relative;
    constants.thickness = relative ? 0 : settings.screen.thickness;
    constants.thicknessRelative = relative ? settings.screen.thicknessRelative : 0;
    constants.thicknessRelative += techniqueFor(settings.screen.march).depthBias(settings);
}

void setSteps(const Settings& settings, shared::TraceConstants& constants) {
    constants.maxSteps = techniqueFor(settings.screen.march).maxSteps(settings);
    constants.baseSteps = unsignedOf(settings.adaptive.steps);
    constants.pixelSpacing = settings.adaptive.pixelSpacing;
    constants.refinements = unsignedOf(settings.adaptive.refinements);
    constants.step = unsignedOf(settings.screen.step);
    constants.selfCollisionSkip = unsignedOf(settings.screen.selfCollisionSkip);
    constants.minLevel = unsignedOf(settings.hiz.minLevel);
    constants.maxLevel = unsignedOf(std::max(settings.hiz.minLevel, settings.hiz.maxLevel));
}

/// Reflectivity up to which no ray is traced.
float thresholdOf(const Settings& settings) {
    if (settings.reflect.strength <= 0)
        return 2; // nothing is traced
    // Half an 8-bit step more, so that a threshold of 0.04 rejects plain dielectrics in any format of F0.
    const float threshold = settings.reflect.threshold + 1.0f / 510.0f;
    const bool scaled = settings.reflect.thresholdOn == ThresholdOn::F0TimesStrength;
    return scaled ? threshold / std::max(settings.reflect.strength, 1e-30f) : threshold;
}

uint32_t flagsOf(const Settings& settings, bool backFacesKnown) {
    uint32_t flags = 0;
    const auto flag = [&](bool on, uint32_t bit) { flags |= on ? bit : 0; };
    flag(settings.screen.smooth, shared::kTraceSmooth);
    flag(settings.screen.clipToFrustum, shared::kTraceClipToFrustum);
    flag(settings.fade.border == FadeBorder::Smooth, shared::kFadeBorderSmooth);
    flag(settings.fade.border == FadeBorder::Linear, shared::kFadeBorderLinear);
    flag(settings.fade.distance, shared::kFadeDistance);
    flag(settings.fade.iterations, shared::kFadeIterations);
    flag(settings.fade.facingCamera, shared::kFadeFacingCamera);
    flag(settings.fade.backface, shared::kFadeBackface);
    flag(settings.fade.uncertain, shared::kTraceUncertain);
    flag(settings.debug.certainty, shared::kTraceCertainty);
    flag(denoises(settings), shared::kTraceLobe);
    flag(ConePicture::wanted(settings), shared::kTraceCones);
    flag(ConePicture::wanted(settings) && !LobeMean::wanted(settings), shared::kTraceConesAtHits);
    flag(settings.screen.thicknessMode == ThicknessMode::Backface && backFacesKnown, shared::kTraceBackDepth);
    return flags;
}

} // namespace

std::span<const Technique> techniques() {
    return kTechniques;
}

const Technique& techniqueFor(March march) {
    const std::span<const Technique> all = techniques();
    const auto found = std::ranges::find(all, march, &Technique::march);
    GLINT_ASSERT(found != all.end(), "march {}", static_cast<int>(march));
    return *found;
}

size_t indexOf(const Technique& technique) {
    return static_cast<size_t>(&technique - kTechniques.data());
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

void recordMarch(gpu::Frame& frame, const Technique& technique, const gpu::Pipeline& pipeline, TraceInputs inputs,
                 TraceTarget out) {
    gpu::Image& environment = inputs.frame.host.environment;
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("frame", inputs.frame.constants)
        .read("rays", inputs.rays.list)
        .read("viewZ", inputs.prepared.viewZ)
        .read("backViewZ", inputs.met.backViewZ, kTexels)
        .read("surface", inputs.prepared.surface)
        .read("environment", environment ? environment : inputs.frame.standIns.blackCube)
        .read("blueNoise", inputs.frame.standIns.blueNoise);
    readHitColor(pass, inputs);
    if (inputs.log)
        pass.readWrite("rayLog", *inputs.log);
    pass.readWrite("radianceWeight", out.radianceWeight) // the pass that classifies wrote the rest, if it is read
        .readWrite("radianceWeight8", out.radianceWeight8)
        .readWrite("rayRecord", out.rayRecord);
    if (technique.usesPyramid)
        pass.read("pyramid", inputs.pyramid.cells);
    if (technique.usesProbes)
        bindLists(pass, inputs);
    pass.dispatchIndirect(inputs.rays.list);
}

shared::TraceConstants traceConstants(const Settings& settings, bool backFacesKnown) {
    shared::TraceConstants constants = {};
    setThickness(settings, constants);
    setSteps(settings, constants);
    constants.maxDistance = settings.screen.maxDistance;
    // With a blur, roughness sets its width instead: jitter would only add noise.
    constants.roughnessFactor = settings.blur.strength > 0 || denoises(settings) ? 0 : settings.rough.factor;
    constants.inferredWeight = settings.screen.inferred;
    constants.roughnessFadeStart = settings.reflect.roughnessFadeStart;
    constants.maxRoughness = settings.reflect.maxRoughness;
    constants.borderWidth = settings.fade.borderWidth;
    constants.threshold = thresholdOf(settings);
    constants.flags = flagsOf(settings, backFacesKnown);
    return constants;
}

} // namespace glint::reflect
