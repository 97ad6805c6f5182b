// How the source `rays` treats the screen's answers. It replaces the answers that it knows better: hits that the
// marcher guessed, hits at edges of the frame, and hits on reflective surfaces, whose colour in the host's frame lacks
// their own reflections. Include after rays_inputs.glsl, or after list.comp's own declarations of the same inputs.
#ifndef GLINT_RAYS_AFTER_SCREEN_GLSL
#define GLINT_RAYS_AFTER_SCREEN_GLSL

#include "lib/history.glsl"
#include "lib/math.glsl"
#include "lib/ray_record.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "frame/lobe_surfaces.glsl"
#include "rays/shown_pixel.glsl"
#include "shared/hierarchy.h"

layout(set = 0, binding = 23) uniform usampler2D screenRecord;

bool isAfterScreen() {
    return (settings.before & (1u << kSourceScreen)) != 0u;
}

ivec2 hitPixel(RayRecord ray) {
    return min(ivec2(ray.hitUV * frame.constants.size), ivec2(frame.constants.size) - 1);
}

vec3 shownWS(ivec2 px) {
    vec3 positionVS =
        viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, texelFetch(viewZ, px, 0).r);
    return (frame.constants.viewToWorld * vec4(positionVS, 1.0)).xyz;
}

/// True if a transparent surface may lie between what two pixels show. The depth buffer that the screen's ray marches
/// through has no transparent surfaces.
bool mayPassTransparents(ivec2 from, ivec2 to) {
    if ((settings.flags & kRaysTransparents) == 0u)
        return false;
    vec3 startWS = shownWS(from);
    vec3 wayWS = shownWS(to) - startWS;
    vec3 inverse = 1.0 / mix(wayWS, vec3(1e-20), lessThan(abs(wayWS), vec3(1e-20)));
    vec3 a = (settings.transparentsLow - startWS) * inverse;
    vec3 b = (settings.transparentsHigh - startWS) * inverse;
    return max(maxComponent(min(a, b)), 0.0) <= min(-maxComponent(-max(a, b)), 1.0);
}

/// How the screen's ray of a pixel ended. A transparent surface in its path counts as passed behind: the depth buffer
/// does not show it.
RayRecord screenRay(ivec2 px) {
    RayRecord ray = unpackRayRecord(texelFetch(screenRecord, fullToTracePixel(frame.constants, px), 0).xy);
    if (isAnswered(ray.outcome) && mayPassTransparents(px, hitPixel(ray)))
        ray.uncertain = true;
    return ray;
}

/// True if the ray hit a surface whose own reflection a further bounce would find. A surface that reflects no more than
/// plain dielectrics may keep the environment that its colour holds. The previous frame's colour shows reflections
/// already.
bool metReflector(RayRecord ray) {
    const float kPlain = 0.08;
    if (!isAnswered(ray.outcome) || settings.bounces < 2u || hasHistory(frame.constants))
        return false;
    Surface met = shownAt(hitPixel(ray));
    return met.reflectivity > max(settings.threshold, kPlain) && met.perceptualRoughness <= settings.maxRoughness;
}

/// True if the ray hit what the frame shows, with no occluder hidden before it, well inside the frame, on a surface
/// that looks alike from everywhere.
bool isCertain(RayRecord ray) {
    return ray.outcome == kOutcomeHit && !ray.uncertain && !isAtEdge(ray.hitUV * frame.constants.size) &&
           looksAlike(shownAt(hitPixel(ray)));
}

/// True if the screen's answer does not count for this pixel, because rays know it better.
bool takesBack(RayRecord ray) {
    return isAfterScreen() && isAnswered(ray.outcome) && (!isCertain(ray) || metReflector(ray));
}

#endif
