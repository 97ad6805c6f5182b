// lib/refraction.glsl for the test's arguments.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/refraction.glsl"

layout(local_size_x = 64) in;

struct Item {
    vec3 normal;
    vec3 toEye;
    uint model;
    float ior;
    float thickness;
    vec3 exit;
    vec3 direction;
    float pathLength;
    uint isTotal;
    uint inner;
};

layout(scalar, set = 0, binding = 0) buffer ItemBlock {
    Item list[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(items.list.length()))
        return;
    Item item = items.list[i];
    Refraction r = refractThrough(item.model, item.normal, item.toEye, item.ior, item.thickness, item.inner);
    items.list[i].exit = r.exit;
    items.list[i].direction = r.direction;
    items.list[i].pathLength = r.pathLength;
    items.list[i].isTotal = r.isTotal ? 1u : 0u;
}
