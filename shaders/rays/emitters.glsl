// Emissive triangles that paths sample directly: the list of the instances that emit light (shared/light_tree.h), and
// their triangles. Include after surface_table.glsl.
#ifndef GLINT_RAYS_EMITTERS_GLSL
#define GLINT_RAYS_EMITTERS_GLSL

#include "rays/surface_table.glsl"
#include "shared/light_tree.h"

layout(scalar, set = 0, binding = 25) readonly buffer EmittersBlock {
    EmittersHeader header;
    uint words[];
}
emitters;

struct EmitterTriangle {
    uint instance;
    uint primitive;
};

/// The first leaf of an instance's triangles, or kNoEmitter.
uint emitterLeaf(uint instance) {
    return instance < emitters.header.instances ? emitters.words[instance] : kNoEmitter;
}

EmitterTriangle emitterTriangle(uint leaf) {
    uint low = 0u;
    uint high = emitters.header.emitters; // the emitter is in [low, high)
    while (low + 1u < high) {
        uint middle = (low + high) / 2u;
        if (emitters.words[emitters.header.instances + 2u * middle] <= leaf)
            low = middle;
        else
            high = middle;
    }
    uint at = emitters.header.instances + 2u * low;
    return EmitterTriangle(emitters.words[at + 1u], leaf - emitters.words[at]);
}

struct TriangleWS {
    vec3 a;
    vec3 u; // sides from `a`
    vec3 v;
};

TriangleWS triangleWS(SurfaceInstanceRecord placed, SurfaceMeshRecord mesh, uvec3 triangle) {
    mat3 linear = transpose(mat3(placed.localToWorld[0].xyz, placed.localToWorld[1].xyz, placed.localToWorld[2].xyz));
    vec3 translation = vec3(placed.localToWorld[0].w, placed.localToWorld[1].w, placed.localToWorld[2].w);
    vec3 a = load3(mesh.positions, triangle.x);
    return TriangleWS(linear * a + translation, linear * (load3(mesh.positions, triangle.y) - a),
                      linear * (load3(mesh.positions, triangle.z) - a));
}

#endif
