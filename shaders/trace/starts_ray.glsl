// Which pixels need a ray of the screen's. The others get their answer here, none, if any pass asks for it.
// With GLINT_NEIGHBOURS_ANSWER a pixel may also take its light from its neighbours' rays (reuse.rate): include after
// `rayRates` (denoise/ray_rate.glsl) then.
#ifndef GLINT_TRACE_STARTS_RAY_GLSL
#define GLINT_TRACE_STARTS_RAY_GLSL

#include "generate/lobe.glsl"
#include "generate/pixel_ray.glsl"
#include "lib/camera.glsl"
#include "lib/fades.glsl"
#include "lib/surface.glsl"
#include "shared/trace_constants.h"
#include "trace/traced.glsl"
#ifdef GLINT_NEIGHBOURS_ANSWER
#include "denoise/lobe_turn.glsl"
#include "denoise/ray_rate.glsl"
#endif

/// Returns kOutcomeNone where a ray is needed.
uint whyNoRay(ivec2 px, vec2 uv, float z, Surface here) {
    TraceConstants settings = frame.settings.trace;
    if (here.reflectivity <= settings.threshold)
        return kOutcomeBelowThreshold;
    if (fadeRoughness(here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness) <= 0.0)
        return kOutcomeTooRough;
    if ((settings.flags & kFadeFacingCamera) != 0u) {
        PixelRay ray = generateRay(uv, z, here);
        if (fadeFacingCamera(dot(-viewDirection(frame.constants, ray.originVS), ray.directionVS)) <= 0.0)
            return kOutcomeFacingCamera;
    }
#ifdef GLINT_NEIGHBOURS_ANSWER
    if (!sendsRay(px, here.perceptualRoughness) || !hasLobesTurn(px, uv))
        return kOutcomeFromNeighbours;
#endif
    return kOutcomeNone;
}

/// True if the surface `here`, at `z` metres in pixel `px`, needs a ray. If not, stores that the traced pixel has no
/// answer, unless whoever asks looks at the ray list (kTraceListedOnly). `fromRough`: the ray starts on a rough surface;
/// known for cones alone.
bool startsRay(ivec2 tracePX, ivec2 px, float z, Surface here, out bool fromRough) {
    vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
    RayRecord record = RayRecord(uv, 0.0, 0u, kOutcomeNone, false);
    bool starts = false;
    fromRough = false;
    if (z < kBackgroundZ) {
        record.outcome = whyNoRay(px, uv, z, here);
        starts = record.outcome == kOutcomeNone;
        fromRough = (frame.settings.trace.flags & kTraceCones) != 0u && !isMirror(here.perceptualRoughness);
    }
    if (!starts && (frame.settings.trace.flags & kTraceListedOnly) == 0u)
        storeTraced(tracePX, vec3(0.0), 0.0, record);
    return starts;
}

#endif
