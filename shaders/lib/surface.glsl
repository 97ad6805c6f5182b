// A pixel's surface as `prepare` packs it into two words: octahedral view-space normal (2 x snorm16), perceptual
// roughness and reflectivity (2 x unorm16). Besides depth, tracing reads only these eight bytes. Sixteen bits a
// component keep a mirror's reflection within a tenth of a pixel.
#ifndef GLINT_LIB_SURFACE_GLSL
#define GLINT_LIB_SURFACE_GLSL

#include "lib/math.glsl"
#include "lib/octahedral.glsl"

struct Surface {
    vec3 normalVS;            // unit
    float perceptualRoughness; // [0, 1]
    float reflectivity;        // largest channel of F0, [0, 1]; 0: nothing is reflected, or the background shows
};

uvec2 packSurface(Surface surface) {
    return uvec2(packSnorm2x16(encodeOctahedral(surface.normalVS)),
                 packUnorm16(vec2(surface.perceptualRoughness, surface.reflectivity)));
}

Surface unpackSurface(uvec2 packed) {
    vec2 scalars = unpackUnorm2x16(packed.y);
    return Surface(decodeOctahedral(unpackSnorm2x16(packed.x)), scalars.x, scalars.y);
}

/// Of packed surfaces, to the last bit.
bool haveOneNormal(uvec2 packedA, uvec2 packedB) {
    return packedA.x == packedB.x;
}

#endif
