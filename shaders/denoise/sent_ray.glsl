// The one ray that a rough pixel sent in this frame, as its neighbours read it: denoise/gather stores it, denoise/reuse
// reads it for every pair, which costs less than drawing the direction anew.
#ifndef GLINT_DENOISE_SENT_RAY_GLSL
#define GLINT_DENOISE_SENT_RAY_GLSL

#include "lib/octahedral.glsl"

struct SentRay {
    vec3 directionVS; // to 6.5e-5 radians
    float nearness;   // 1 / metres to where it ended; 0: infinitely far
    bool sent;
    bool awaits; // sent none, but reflects: takes what neighbours' rays found (reuse.rate)
};

uvec2 packSentRay(SentRay ray) {
    if (!ray.sent)
        return uvec2(0u, floatBitsToUint(ray.awaits ? -2.0 : -1.0));
    return uvec2(packSnorm2x16(encodeOctahedral(ray.directionVS)), floatBitsToUint(ray.nearness));
}

SentRay unpackSentRay(uvec2 packed) {
    float nearness = uintBitsToFloat(packed.y);
    return SentRay(decodeOctahedral(unpackSnorm2x16(packed.x)), max(nearness, 0.0), nearness >= 0.0,
                   nearness == -2.0);
}

#endif
