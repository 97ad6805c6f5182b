// The numbers behind a pixel's random directions.
#ifndef GLINT_RAYS_RAY_NOISE_GLSL
#define GLINT_RAYS_RAY_NOISE_GLSL

#include "lib/noise.glsl"
#include "shared/rays_constants.h"

layout(scalar, set = 0, binding = 6) readonly buffer BlueNoiseBlock {
    uint mask[]; // kBlueNoiseSize^2 texels: two ranks of 16 bits
}
blueNoise;

/// Point `index` of an endless sequence that fills the square evenly however far it is taken: the generalized golden
/// ratio in two dimensions. Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", in 32-bit
/// fractions.
uvec2 quasirandom(uint index) {
    return index * uvec2(3242174889u, 2447445414u);
}

/// Two numbers in [0, 1) for sample `index` of a pixel, counted on over the frames. Its neighbours' are unlike it (blue
/// noise: the mask), and so are its own of other samples and frames (the sequence): errors are spread over space and
/// time.
vec2 firstBounceNoise(ivec2 px, uint index, uint seed) {
    uvec2 shifted = uvec2(px) + uvec2(seed * 0x9e3779b9u >> 8, seed * 0x85ebca6bu >> 8);
    uvec2 at = shifted % kBlueNoiseSize;
    uint texel = blueNoise.mask[at.y * kBlueNoiseSize + at.x];
    uvec2 fractions = uvec2(texel << 16, texel & 0xffff0000u) + 0x8000u + quasirandom(index);
    return vec2(fractions >> 8) * (1.0 / 16777216.0);
}

/// Later bounces: nothing is gained by spreading what has been scattered already.
vec2 laterBounceNoise(ivec2 px, uint index, uint bounce, uint seed) {
    return hashNoise(uvec2(px), index * 8u + bounce, seed).xy;
}

#endif
