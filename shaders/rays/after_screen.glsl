// What the source `rays` makes of the screen's answers. It takes back those that it knows better: hits that the marcher
// had to guess, hits at edges of the picture, and hits on something that reflects itself, whose colour in the host's
// picture lacks just that. Include after rays_inputs.glsl, or what list.comp declares in its place.
#ifndef GLINT_RAYS_AFTER_SCREEN_GLSL
#define GLINT_RAYS_AFTER_SCREEN_GLSL

#include "lib/ray_record.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "rays/shown_pixel.glsl"
#include "shared/hierarchy.h"

layout(set = 0, binding = 23) uniform usampler2D screenRecord;

bool isAfterScreen() {
    return (settings.before & (1u << kSourceScreen)) != 0u;
}

/// How the screen's ray of a pixel ended.
RayRecord screenRay(ivec2 px) {
    return unpackRayRecord(texelFetch(screenRecord, fullToTracePixel(frame.constants, px), 0).xy);
}

ivec2 hitPixel(RayRecord ray) {
    return min(ivec2(ray.hitUV * frame.constants.size), ivec2(frame.constants.size) - 1);
}

/// Did it meet something whose own reflection a further bounce would find? What reflects no more than plain dielectrics
/// do may keep the environment that its colour holds. The last frame's picture shows reflections already.
bool metReflector(RayRecord ray) {
    const float kPlain = 0.08;
    if (!isAnswered(ray.outcome) || settings.bounces < 2u || (frame.constants.flags & kInputHistory) != 0u)
        return false;
    Surface met = unpackSurface(texelFetch(surface, hitPixel(ray), 0).xy);
    return met.reflectivity > max(settings.threshold, kPlain) && met.perceptualRoughness <= settings.maxRoughness;
}

/// Did it meet what the picture shows, with nothing hidden before, well inside, and as it looks from everywhere?
bool isCertain(RayRecord ray) {
    return ray.outcome == kOutcomeHit && !ray.passedBehind && !isAtEdge(ray.hitUV * frame.constants.size) &&
           looksAlike(unpackSurface(texelFetch(surface, hitPixel(ray), 0).xy));
}

/// The screen's answer does not count for this pixel: rays know it better.
bool takesBack(RayRecord ray) {
    return isAfterScreen() && isAnswered(ray.outcome) && (!isCertain(ray) || metReflector(ray));
}

#endif
