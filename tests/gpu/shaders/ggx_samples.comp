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
    uint reflected; // 1: only normals that may reflect upwards
    vec3 wm;      // out: the microfacet's normal
    float weight; // out: of the reflected direction; 0 below the surface
};

layout(scalar, set = 0, binding = 0) buffer ItemBlock {
    Item list[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(items.list.length()))
        return;
    Item item = items.list[i];
    bool reflected = item.reflected != 0u;
    item.wm = reflected ? sampleGGXReflected(item.wo, item.u, item.alpha) : sampleGGXVisibleCap(item.wo, item.u, item.alpha);
    vec3 wi = reflect(-item.wo, item.wm);
    item.weight = 0.0;
    if (wi.z > 0.0)
        item.weight = reflected ? reflectedGGXWeight(item.wo.z, wi.z, item.alpha)
                                : visibleGGXWeight(item.wo.z, wi.z, item.alpha);
    items.list[i] = item;
}
