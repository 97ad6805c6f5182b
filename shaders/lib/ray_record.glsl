// What is kept of a traced ray, in two words: hit position on screen (2 x unorm16), its distance in metres (15 bits of a
// half, in whose sign's place stands whether its answer is uncertain), the lookups that it took (12 bits) and why it
// ended (4 bits).
#ifndef GLINT_LIB_RAY_RECORD_GLSL
#define GLINT_LIB_RAY_RECORD_GLSL

#include "lib/math.glsl"
#include "shared/outcome.h"

struct RayRecord {
    vec2 hitUV;        // [0, 1]^2; where the ray ended if it hit nothing
    float hitDistance; // metres from the surface; 0 without a ray
    uint lookups;      // reads of any depth image
    uint outcome;      // kOutcome*
    bool uncertain;    // something hid a part of its way, or the answer is likely to be wrong
};

/// Did the ray bring back a colour?
bool isAnswered(uint outcome) {
    return outcome == kOutcomeHit || outcome == kOutcomeSide || outcome == kOutcomeBackFace ||
           outcome == kOutcomeInferred;
}

uvec2 packRayRecord(RayRecord ray) {
    const float kLargestHalf = 65504.0;
    uint distance = packHalf2x16(vec2(min(ray.hitDistance, kLargestHalf), 0.0)) & 0x7fffu;
    distance |= ray.uncertain ? 0x8000u : 0u; // no distance is negative
    return uvec2(packUnorm16(ray.hitUV),
                 distance | (min(ray.lookups, kMaxLookups) << 16) | (ray.outcome << 28));
}

RayRecord unpackRayRecord(uvec2 packed) {
    return RayRecord(unpackUnorm2x16(packed.x), unpackHalf2x16(packed.y & 0x7fffu).x, (packed.y >> 16) & 0xfffu,
                     packed.y >> 28, (packed.y & 0x8000u) != 0u);
}

#endif
