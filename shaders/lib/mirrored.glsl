// What a mirror shows where its ray met a rough surface: the light that this surface sends by itself, which is exact, and
// a share of what one further ray found in its lobe, which is noise. rays/reflect stores both apart; the denoiser averages
// the second as a signal of the surface that was met. NVIDIA's path tracers replace mirrors likewise ("primary surface
// replacement": Zimmer et al. 2015, "Path-space Motion Estimation and Decomposition for Robust Animation Filtering").
#ifndef GLINT_LIB_MIRRORED_GLSL
#define GLINT_LIB_MIRRORED_GLSL

#include "lib/half.glsl"
#include "lib/octahedral.glsl"

/// The surface that a mirror shows in a pixel.
struct MirroredSurface {
    float distance; // metres from the mirror; 0: nothing is to be denoised there
    vec3 normalVS;  // of the surface itself, not of its image
    float perceptualRoughness; // of the lobe in which the path went on
    float viewZ;               // at which a pixel is as wide as there, metres
    float nearness;            // 1 / metres to where the further ray ended; 0: infinitely far
};

/// The pixel's light is exact + share * what the further ray found.
struct MirroredLight {
    vec3 exact;
    vec3 share;
    /// From rays/reflect: the further ray's direction, octahedral in view space. From denoise/gather: the light's weight, the
    /// two others times that.
    uint last;
};

uvec4 packMirroredSurface(MirroredSurface s) {
    return uvec4(floatBitsToUint(s.distance), packSnorm2x16(encodeOctahedral(s.normalVS)),
                 packHalf2x16(vec2(s.perceptualRoughness, min(s.viewZ, kLargestStored))), floatBitsToUint(s.nearness));
}

MirroredSurface unpackMirroredSurface(uvec4 packed) {
    vec2 halves = unpackHalf2x16(packed.z);
    return MirroredSurface(uintBitsToFloat(packed.x), decodeOctahedral(unpackSnorm2x16(packed.y)), halves.x, halves.y,
                           uintBitsToFloat(packed.w));
}

uvec4 packMirroredLight(MirroredLight light) {
    return uvec4(packHalf2x16(light.exact.rg), packHalf2x16(vec2(light.exact.b, light.share.r)),
                 packHalf2x16(light.share.gb), light.last);
}

MirroredLight unpackMirroredLight(uvec4 packed) {
    vec2 middle = unpackHalf2x16(packed.y);
    return MirroredLight(vec3(unpackHalf2x16(packed.x), middle.x), vec3(middle.y, unpackHalf2x16(packed.z)), packed.w);
}

#endif
