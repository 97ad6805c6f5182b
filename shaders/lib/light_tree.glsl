// Draws a light with probability proportional to its weight, from a tree of sums (shared/light_tree.h). Every depth takes
// random bits of its own, so that lights are told apart however small their share is.
#ifndef GLINT_LIB_LIGHT_TREE_GLSL
#define GLINT_LIB_LIGHT_TREE_GLSL

#include "lib/light_tree_layout.glsl"
#include "lib/noise.glsl"

/// Defined by the entry: four weights.
vec4 loadLightGroup(uint group);

/// The arguments of hashNoise for one draw. The draw uses the seeds from `seed` to `seed` + 3.
struct LightNoise {
    uvec2 px;
    uint index;
    uint seed;
};

struct DrawnLight {
    uint leaf;
    float probability; // 0: no light has any weight
};

float lightTreeTotal(uint firstGroup) {
    return dot(loadLightGroup(firstGroup), vec4(1.0));
}

/// Probability of drawing `leaf`.
float lightProbability(uint firstGroup, uint depth, uint leaf) {
    float weight = loadLightGroup(firstGroup + lightGroupsAbove(depth) + (leaf >> 2u))[leaf & 3u];
    return weight > 0.0 ? weight / lightTreeTotal(firstGroup) : 0.0;
}

DrawnLight drawLight(uint firstGroup, uint depth, LightNoise noise) {
    float total = lightTreeTotal(firstGroup);
    if (!(total > 0.0))
        return DrawnLight(0u, 0.0);
    uint node = 0u;
    float weight = 0.0;
    vec3 u = vec3(0.0);
    for (uint d = 0u; d <= depth; ++d) {
        if (d % 3u == 0u)
            u = hashNoise(noise.px, noise.index, noise.seed + d / 3u);
        vec4 weights = loadLightGroup(firstGroup + lightGroupsAbove(d) + node);
        vec3 upTo = vec3(weights.x, weights.x + weights.y, weights.x + weights.y + weights.z);
        float at = u[d % 3u] * (upTo.z + weights.w);
        uint child = at < upTo.x ? 0u : at < upTo.y ? 1u : at < upTo.z ? 2u : 3u;
        while (weights[child] <= 0.0 && child > 0u) // sums are rounded
            --child;
        weight = weights[child];
        node = 4u * node + child;
    }
    return DrawnLight(node, weight / total);
}

#endif
