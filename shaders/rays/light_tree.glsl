// The trees of lights that paths sample directly (shared/light_tree.h), for the shaders that draw from them.
#ifndef GLINT_RAYS_LIGHT_TREE_GLSL
#define GLINT_RAYS_LIGHT_TREE_GLSL

#include "lib/light_tree.glsl"

layout(scalar, set = 0, binding = 24) readonly buffer LightTreeBlock {
    vec4 groups[];
}
lightTree;

vec4 loadLightGroup(uint group) {
    return lightTree.groups[group];
}

#endif
