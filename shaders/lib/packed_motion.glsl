// A displacement in metres as one word: its direction in twenty bits, to 0.1 degrees; its length in twelve, as a half
// without sign and last bits, to 0.4 % and at most 60 km.
#ifndef GLINT_LIB_PACKED_MOTION_GLSL
#define GLINT_LIB_PACKED_MOTION_GLSL

#include "lib/math.glsl"
#include "lib/octahedral.glsl"

const uint kNoMotion = 0u;

uint packMotion(vec3 metres) {
    const float kLongest = 6.0e4;
    float size = length(metres);
    if (!(size > 0.0)) // nor NaN
        return kNoMotion;
    uint bits = (packHalf2x16(vec2(min(size, kLongest), 0.0)) + 4u) >> 3;
    vec2 direction = encodeOctahedral(metres / size) * 511.0 + 511.0;
    uvec2 steps = uvec2(floorToInt(clamp(direction + 0.5, vec2(0.0), vec2(1022.0))));
    return (bits << 20) | (steps.y << 10) | steps.x;
}

vec3 unpackMotion(uint packed) {
    float size = unpackHalf2x16((packed >> 20) << 3).x;
    if (size == 0.0)
        return vec3(0.0);
    vec2 direction = (vec2(packed & 1023u, (packed >> 10) & 1023u) - 511.0) / 511.0;
    return decodeOctahedral(direction) * size;
}

#endif
