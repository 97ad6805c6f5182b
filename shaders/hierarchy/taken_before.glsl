// What the sources before one have taken of a pixel's weight, for the sources that are asked only for the rest.
#ifndef GLINT_HIERARCHY_TAKEN_BEFORE_GLSL
#define GLINT_HIERARCHY_TAKEN_BEFORE_GLSL

#include "shared/hierarchy.h"
#include "shared/rays_constants.h"

// Looked at where `before` says so: none is the image that the asking source writes.
layout(set = 0, binding = 3) uniform sampler2D earlierScreen;
layout(set = 0, binding = 4) uniform sampler2D earlierRays;
layout(set = 0, binding = 5) uniform usampler2D earlierRaysRecord;
layout(set = 0, binding = 6) uniform sampler2D earlierPlanar;
layout(set = 0, binding = 7) uniform sampler2D earlierProbes;

/// `before`: bit s: source s is asked before.
float takenBefore(uint before, ivec2 px) {
    if ((before & (1u << kSourceSky)) != 0u)
        return 1.0;
    float taken = 0.0;
    bool rays = (before & (1u << kSourceRays)) != 0u;
    bool replaced = rays && (texelFetch(earlierRaysRecord, px, 0).z & kRaysReplaceScreen) != 0u;
    if ((before & (1u << kSourceScreen)) != 0u && !replaced)
        taken += clamp(texelFetch(earlierScreen, px, 0).a, 0.0, 1.0);
    if (rays)
        taken += clamp(texelFetch(earlierRays, px, 0).a, 0.0, 1.0);
    if ((before & (1u << kSourcePlanar)) != 0u)
        taken += clamp(texelFetch(earlierPlanar, px, 0).a, 0.0, 1.0);
    if ((before & (1u << kSourceProbes)) != 0u)
        taken += clamp(texelFetch(earlierProbes, px, 0).a, 0.0, 1.0);
    return min(taken, 1.0);
}

#endif
