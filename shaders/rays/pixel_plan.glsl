// How many paths a listed pixel follows, where they start, and what finds their light.
#ifndef GLINT_RAYS_PIXEL_PLAN_GLSL
#define GLINT_RAYS_PIXEL_PLAN_GLSL

#include "denoise/history.glsl"
#include "lib/mirrored.glsl"
#include "rays/after_screen.glsl"
#include "rays/light_sampling.glsl"
#include "rays/pixel_rays.glsl"
#include "rays/reflect_images.glsl"

/// True if the pixel's paths are stored in two parts: lib/mirrored.glsl.
bool splitsPaths(PixelRays from) {
    return isOn(kRaysBranches) && isMirror(from.perceptualRoughness);
}

/// True if the first hit of this pixel's only path is in the screen's answer.
bool startsOnScreen(bool mirror, RayRecord screen) {
    return mirror && isAfterScreen() && isCertain(screen) && metReflector(screen) &&
           frame.constants.traceSize == frame.constants.size;
}

/// Frames in the mean that the denoiser will join this pixel's answer to: those of the mean that the previous frame left
/// here. In motion the mean comes from some pixels away, where it is as long unless there is an edge between them.
float framesBefore(PixelRays from) {
    if (!hasDenoiserHistory())
        return 0.0;
    float frames = texelFetch(metaBefore, ivec2(from.uv * frame.constants.prevSize), 0).x;
    if (frames <= 1.0 && isMirror(from.perceptualRoughness))
        return 0.0; // nothing is averaged
    return min(frames, frame.settings.denoise.historyFrames - 1.0);
}

struct PixelPlan {
    uint samples;    // paths
    bool mirror;     // all of them start in the mirror direction
    bool fromScreen; // the only one starts with the hit of the screen's ray
    RayRecord screen;
    bool splits;     // splitsPaths
    bool lights;     // rays to lights start at the pixel's own surface
    bool skyApart;   // the light that they find is stored by itself
    bool lightsOnly; // nothing else is asked
    bool replacesScreen; // as the list says, where the answer is the lights' alone
    LobeFrame lobe;
    float meanOver; // frames that the denoiser's mean has, with this one
};

PixelPlan planPixel(PixelRays from) {
    PixelPlan plan;
    plan.mirror = isOn(kRaysMirror) || from.perceptualRoughness < kMirrorRoughness;
    plan.samples = plan.mirror && settings.bounces == 1u ? 1u : settings.samples; // further samples would be equal
    plan.screen = screenRay(from.px);
    plan.fromScreen = startsOnScreen(plan.mirror, plan.screen);
    plan.splits = splitsPaths(from);
    float roughness = sampledRoughness(from.perceptualRoughness);
    plan.skyApart = samplesSky(roughness) && !plan.fromScreen;
    plan.lights = plan.skyApart || (samplesLights(roughness) && !plan.fromScreen);
    uint listed = plan.skyApart ? imageLoad(raysRecord, from.px).z : 0u;
    plan.lightsOnly = (listed & kRaysLightsOnly) != 0u;
    plan.replacesScreen = (listed & kRaysReplaceScreen) != 0u;
    plan.lobe = makeLobeFrame(from.N, from.V, from.perceptualRoughness);
    plan.meanOver = 1.0 + framesBefore(from);
    return plan;
}

#endif
