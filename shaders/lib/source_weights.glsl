// The weight that each source has in a pixel: six weights of ten bits in two words.
#ifndef GLINT_LIB_SOURCE_WEIGHTS_GLSL
#define GLINT_LIB_SOURCE_WEIGHTS_GLSL

#include "lib/math.glsl"
#include "shared/hierarchy.h"

const uint kWeightBits = 10u;
const uint kWeightMask = (1u << kWeightBits) - 1u;

uvec2 packSourceWeights(float weights[kMaxSources]) {
    uvec2 packed = uvec2(0u);
    for (uint i = 0u; i < kMaxSources; ++i) {
        int weight = floorToInt(clamp(weights[i], 0.0, 1.0) * float(kWeightMask) + 0.5);
        packed[i / 3u] |= uint(weight) << (kWeightBits * (i % 3u));
    }
    return packed;
}

float sourceWeight(uvec2 packed, uint source) {
    return float((packed[source / 3u] >> (kWeightBits * (source % 3u))) & kWeightMask) / float(kWeightMask);
}

#endif
