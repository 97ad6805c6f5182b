// What the sources before one have taken of a pixel's weight, for the sources that are asked only for the rest.
#ifndef GLINT_HIERARCHY_TAKEN_BEFORE_GLSL
#define GLINT_HIERARCHY_TAKEN_BEFORE_GLSL

#include "shared/hierarchy.h"
#include "shared/rays_constants.h"

layout(set = 0, binding = 3) uniform sampler2D screenAnswer;
layout(set = 0, binding = 4) uniform sampler2D raysAnswer;
layout(set = 0, binding = 5) uniform usampler2D raysRecord;
layout(set = 0, binding = 6) uniform sampler2D otherAnswer; // of planar or probes: the one of them that does not ask

/// `before`: bit s: source s is asked before.
float takenBefore(uint before, ivec2 px) {
    if ((before & (1u << kSourceSky)) != 0u)
        return 1.0;
    float taken = 0.0;
    bool rays = (before & (1u << kSourceRays)) != 0u;
    bool replaced = rays && (texelFetch(raysRecord, px, 0).z & kRaysReplaceScreen) != 0u;
    if ((before & (1u << kSourceScreen)) != 0u && !replaced)
        taken += clamp(texelFetch(screenAnswer, px, 0).a, 0.0, 1.0);
    if (rays)
        taken += clamp(texelFetch(raysAnswer, px, 0).a, 0.0, 1.0);
    if ((before & ((1u << kSourcePlanar) | (1u << kSourceProbes))) != 0u)
        taken += clamp(texelFetch(otherAnswer, px, 0).a, 0.0, 1.0);
    return min(taken, 1.0);
}

#endif
