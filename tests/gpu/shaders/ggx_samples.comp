// Directions of lib/sampling.glsl's spherical caps, and their weights.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/sampling.glsl"

layout(local_size_x = 64) in;

struct Item {
    vec3 wo; // unit, z > 0
    float alpha;
    vec2 u;       // [0, 1)^2
    vec3 wm;      // out: the microfacet's normal
    float weight; // out: G2 / G1 of the reflected direction; 0 below the surface
};

layout(scalar, set = 0, binding = 0) buffer ItemBlock {
    Item list[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(items.list.length()))
        return;
    Item item = items.list[i];
    item.wm = sampleGGXVisibleCap(item.wo, item.u, item.alpha);
    vec3 wi = reflect(-item.wo, item.wm);
    item.weight = wi.z > 0.0 ? visibleGGXWeight(item.wo.z, wi.z, item.alpha) : 0.0;
    items.list[i] = item;
}
