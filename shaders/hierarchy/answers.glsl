// Each source's answer for a pixel, as images: radiance and weight.
#ifndef GLINT_HIERARCHY_ANSWERS_GLSL
#define GLINT_HIERARCHY_ANSWERS_GLSL

#include "hierarchy/walk.glsl"
#include "shared/hierarchy.h"
#include "shared/rays_constants.h"

// Indexed by source number; black where the source has no image. The image that the calling source writes is not among
// them.
layout(set = 0, binding = 3) uniform sampler2D answers[kMaxSources];
layout(set = 0, binding = 5) uniform usampler2D answersRaysRecord; // read only if `sources` includes the source `rays`

/// `sources`, bit s: source s counts. Pixels for which rays found a better answer lose the screen's answer. A constant
/// index needs no device feature.
vec4 loadAnswer(uint source, uint sources, ivec2 px) {
    switch (source) {
    case kSourceScreen: {
        bool replaced = (sources & (1u << kSourceRays)) != 0u &&
                        (texelFetch(answersRaysRecord, px, 0).z & kRaysReplaceScreen) != 0u;
        return replaced ? vec4(0.0) : texelFetch(answers[0], px, 0);
    }
    case 1u:
        return texelFetch(answers[1], px, 0);
    case 2u:
        return texelFetch(answers[2], px, 0);
    case 3u:
        return texelFetch(answers[3], px, 0);
    case 4u:
        return texelFetch(answers[4], px, 0);
    default:
        return texelFetch(answers[5], px, 0);
    }
}

/// The weight that the sources of `before` took, for a source that answers only for the remaining weight.
float takenBefore(uint before, ivec2 px) {
    if ((before & (1u << kSourceSky)) != 0u)
        return 1.0; // the sky answers everywhere
    Walk walk = beginWalk();
    for (uint source = 0u; source < kMaxSources; ++source)
        if ((before & (1u << source)) != 0u)
            take(walk, loadAnswer(source, before, px));
    return walk.taken;
}

#endif
