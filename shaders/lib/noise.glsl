// Repeatable noise. Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3): pcg3d.
#ifndef GLINT_LIB_NOISE_GLSL
#define GLINT_LIB_NOISE_GLSL

/// Three uniform numbers in [0, 1) for a pixel, a frame and a seed.
vec3 hashNoise(uvec2 px, uint frameIndex, uint seed) {
    uvec3 v = uvec3(px, frameIndex + seed * 0x9e3779b9u);
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return vec3(v >> 8u) * (1.0 / 16777216.0);
}

#endif
