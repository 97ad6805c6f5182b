// The random numbers for a pixel's directions.
#ifndef GLINT_GENERATE_SAMPLE_NOISE_GLSL
#define GLINT_GENERATE_SAMPLE_NOISE_GLSL

#include "lib/noise.glsl"
#include "shared/sample_noise.h"

layout(scalar, set = 0, binding = 41) readonly buffer BlueNoiseBlock {
    uint mask[]; // kBlueNoiseSize^2 texels: two ranks of 16 bits
}
blueNoise;

/// Point `index` of an endless sequence whose every prefix fills the square evenly: the generalized golden ratio in two
/// dimensions. Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences", in 32-bit fractions.
uvec2 quasirandom(uint index) {
    return index * uvec2(3242174889u, 2447445414u);
}

/// Two numbers in [0, 1) for sample `index` of a pixel, counted across frames. The numbers of neighbouring pixels
/// differ (blue noise: the mask), and so do those of the pixel's other samples and frames (the sequence): the error
/// spreads over space and time.
vec2 firstBounceNoise(ivec2 px, uint index, uint seed) {
    uvec2 shifted = uvec2(px) + uvec2(seed * 0x9e3779b9u >> 8, seed * 0x85ebca6bu >> 8);
    uvec2 at = shifted % kBlueNoiseSize;
    uint texel = blueNoise.mask[at.y * kBlueNoiseSize + at.x];
    uvec2 fractions = uvec2(texel << 16, texel & 0xffff0000u) + 0x8000u + quasirandom(index);
    return vec2(fractions >> 8) * (1.0 / 16777216.0);
}

/// Later bounces use plain noise: spreading gains nothing once light is scattered.
vec2 laterBounceNoise(ivec2 px, uint index, uint bounce, uint seed) {
    return hashNoise(uvec2(px), index * 8u + (bounce & 7u), seed + (bounce >> 3) * 0x9e3779b9u).xy;
}

#endif
