// The second surface of a pixel that shows several surfaces: the surface besides the nearest one, for a host with
// several samples a pixel. Four words, kept only for such hosts.
#ifndef GLINT_LIB_EDGE_GLSL
#define GLINT_LIB_EDGE_GLSL

#include "lib/octahedral.glsl"

struct Edge {
    vec3 f0;
    float coverage; // [0, 1] of the pixel; what both surfaces leave is background
    float viewZ;
    vec3 normalVS; // unit
};

uvec4 packEdge(Edge edge) {
    return uvec4(packHalf2x16(edge.f0.rg), packHalf2x16(vec2(edge.f0.b, edge.coverage)), floatBitsToUint(edge.viewZ),
                 packSnorm2x16(encodeOctahedral(edge.normalVS)));
}

Edge unpackEdge(uvec4 packed) {
    vec2 last = unpackHalf2x16(packed.y);
    return Edge(vec3(unpackHalf2x16(packed.x), last.x), last.y, uintBitsToFloat(packed.z),
                decodeOctahedral(unpackSnorm2x16(packed.w)));
}

#endif
