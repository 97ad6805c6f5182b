#include "reflect/frame_plan.hpp"

#include "reflect/denoise/denoises.hpp"
#include "reflect/rays/path_end.hpp"
#include "reflect/resolve/lobe_mean.hpp"
#include "reflect/trace/cone_picture.hpp"
#include "reflect/trace/technique.hpp"
#include "reflect/trace/transparents.hpp"

#include <algorithm>
#include <cmath>

namespace glint::reflect {
namespace {

bool tracesEveryPixel(const PlanInputs& inputs) {
    return tracedPixels(inputs.settings, inputs.width) == inputs.width &&
           tracedPixels(inputs.settings, inputs.height) == inputs.height;
}

/// True if a pass, the host or a view reads how each ray ended.
bool keepsRecord(const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    return inputs.statistics || inputs.views || inputs.inspection || settings.debug.outcome || settings.rays.enabled ||
           !tracesEveryPixel(inputs) || denoises(settings) || settings.blur.strength > 0 ||
           TransparentTrace::wanted(settings) || LobeMean::wanted(settings);
}

void planSources(FramePlan& plan, const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    plan.screen = settings.screen.enabled;
    plan.rays = settings.rays.enabled && inputs.scene;
    plan.planar = settings.planar.enabled && inputs.mirrors;
    plan.probes = settings.probes.enabled && inputs.probes;
    plan.sky = settings.sky.enabled && inputs.environment;
    const bool any = plan.screen || plan.rays || plan.planar || plan.probes || plan.sky;
    plan.reflects = (any && settings.reflect.strength > 0) || settings.debug.outcome;
    plan.shadesHits = plan.rays && inputs.shadesHits;
    plan.sampleLights = plan.rays && !inputs.shadesHits && settings.rays.sampleLights;
    plan.interpolatesRays = plan.rays && !inputs.shadesHits && !denoises(settings) && !settings.rays.accumulate &&
                            settings.rays.interpolate > 0;
}

void planResults(FramePlan& plan, const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    plan.composites = inputs.compositeOutput || !inputs.reflectionOutput;
    plan.coat = inputs.coat && plan.composites && plan.reflects && !settings.debug.outcome;
    plan.combines = inputs.views || inputs.inspection || inputs.reflectionOutput || inputs.manySamples || plan.coat;
    plan.layers = inputs.transparentLayers && settings.refraction.enabled && !settings.debug.outcome && plan.composites;
    plan.records = plan.reflects || plan.layers || inputs.compositeOutput || inputs.reflectionOutput;
    plan.previousEnds = plan.rays && !inputs.shadesHits && plan.composites && endsInPrevious(settings);
    plan.countsRays = inputs.statistics && (plan.screen || plan.rays);
}

void planScreen(FramePlan& plan, const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    plan.tracesScreen = plan.screen && plan.reflects;
    plan.previousColors = plan.screen && settings.screen.colorSource == ColorSource::Previous;
    plan.manySamples = inputs.manySamples;
    plan.resolvesMaterial = inputs.resolvesMaterial;
    plan.backFaces = settings.screen.thicknessMode == ThicknessMode::Backface && inputs.backDepth;
    plan.backFacesInPlace = plan.backFaces && inputs.backDepthFits && !inputs.manySamples;
    plan.pyramid = (plan.tracesScreen && techniqueFor(settings.screen.march).usesPyramid) || plan.layers;
    plan.cones = ConePicture::wanted(settings) && plan.tracesScreen;
    plan.transparents = TransparentTrace::wanted(settings) && plan.tracesScreen && inputs.transparentDepth;
    plan.keepsRecord = keepsRecord(inputs);
    plan.classifiesEarly =
        plan.screen && !inputs.manySamples && !plan.coat && tracesEveryPixel(inputs) && !denoises(settings);
    const bool readByOthers = settings.reflect.strength > 0 && (plan.rays || plan.planar || plan.probes);
    plan.storesListedOnly = plan.classifiesEarly && !plan.keepsRecord && !plan.combines && !readByOthers;
}

void planResolve(FramePlan& plan, const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    plan.blur = plan.tracesScreen && settings.blur.strength > 0 && !denoises(settings);
    const auto isSmaller = [&](uint32_t pixels) {
        const uint32_t traced = tracedPixels(settings, pixels);
        return (plan.blur ? blurredPixels(settings, traced) : traced) < pixels;
    };
    plan.upsample = plan.tracesScreen && (isSmaller(inputs.extentWidth) || isSmaller(inputs.extentHeight));
}

void planDenoiser(FramePlan& plan, const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    plan.denoise = denoises(settings);
    if (!plan.denoise)
        return;
    plan.findsChange = settings.denoise.antilag != Antilag::Off;
    const bool follows = settings.denoise.antilag == Antilag::Gradient;
    plan.followsPaths = follows && plan.rays && !inputs.shadesHits;
    plan.followsPlaces = follows && !plan.followsPaths && plan.screen;
    plan.ratesRays = settings.reuse.rate == RayRate::Adaptive;
    plan.stabilizes = settings.denoise.stabilizeSeconds > 0;
}

} // namespace

void PlanInputs::setImages(const GBuffer& gbuffer, const EnvironmentMap& around) {
    manySamples = gbuffer.depth.samples > 1;
    resolvesMaterial = reflect::resolvesMaterial(gbuffer);
    backDepth = static_cast<bool>(gbuffer.backDepth);
    backDepthFits = gbuffer.backDepth.width == width && gbuffer.backDepth.height == height;
    transparentDepth = static_cast<bool>(gbuffer.transparentDepth);
    coat = hasCoat(gbuffer);
    environment = static_cast<bool>(around.cube);
}

FramePlan planFrame(const PlanInputs& inputs) {
    FramePlan plan;
    planSources(plan, inputs);
    planResults(plan, inputs);
    planScreen(plan, inputs);
    planResolve(plan, inputs);
    planDenoiser(plan, inputs);
    return plan;
}

std::vector<FrameDecision> decisionsOf(const FramePlan& plan) {
    return {
#define GLINT_DECISION(name, meaning) FrameDecision{#name, plan.name},
        GLINT_FRAME_PLAN(GLINT_DECISION)
#undef GLINT_DECISION
    };
}

uint32_t tracedPixels(const Settings& settings, uint32_t pixels) {
    if (denoises(settings)) // each pixel has a sample of its own lobe
        return pixels;
    // 1e-3 less before rounding up, as 0.1f is slightly above a tenth.
    const double wanted = pixels * static_cast<double>(settings.screen.resolutionScale) - 1e-3;
    return static_cast<uint32_t>(std::clamp(std::ceil(wanted), 1.0, static_cast<double>(pixels)));
}

uint32_t blurredPixels(const Settings& settings, uint32_t traced) {
    const auto divisor = static_cast<uint32_t>(settings.blur.downsample) + 1;
    return (traced + divisor - 1) / divisor;
}

} // namespace glint::reflect
