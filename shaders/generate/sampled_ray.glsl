// The one sampled ray of a pixel in this frame: screen and rays follow it together when denoise.enabled is on.
#ifndef GLINT_GENERATE_SAMPLED_RAY_GLSL
#define GLINT_GENERATE_SAMPLED_RAY_GLSL

#include "generate/lobe.glsl"
#include "generate/pixel_ray.glsl"
#include "generate/sample_noise.glsl"

/// Number of sample `i` of this frame, counted across frames.
uint sampleNumber(uint i) {
    return frame.constants.frameIndex * max(frame.settings.rays.samples, 1u) + i;
}

/// The first sample of this frame's lobe of a surface that is no mirror. World space, like the source `rays`: both then
/// draw the same direction to the last bit but for rounding.
Direction sampledDirection(ivec2 px, vec3 positionVS, Surface here) {
    mat3 toWorld = mat3(frame.constants.viewToWorld);
    vec3 V = -(toWorld * viewDirection(frame.constants, positionVS));
    vec2 noise = firstBounceNoise(px, sampleNumber(0u), frame.constants.seed);
    return sampleLobe(toWorld * here.normalVS, V, here.perceptualRoughness, noise);
}

#endif
