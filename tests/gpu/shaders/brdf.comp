// Each term of lib/brdf.glsl, and the split-sum integral of lib/dfg.glsl, for the test's arguments.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/dfg.glsl"

layout(local_size_x = 64) in;

struct Item {
    vec4 cosines; // NoV, NoL, NoH, VoH
    vec4 surface; // f0 (grey), f90, perceptualRoughness, unused
    vec4 terms;   // D, V, F, unused
    vec2 dfg;     // at (NoV, perceptualRoughness)
};

layout(scalar, set = 0, binding = 0) buffer ItemBlock {
    Item list[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(items.list.length()))
        return;
    vec4 cosines = items.list[i].cosines;
    vec4 surface = items.list[i].surface;
    float alpha = square(surface.z);
    items.list[i].terms = vec4(D_GGX(cosines.z, alpha), V_SmithGGXCorrelated(cosines.x, cosines.y, alpha),
                               F_Schlick(vec3(surface.x), surface.y, cosines.w).x, 0.0);
    items.list[i].dfg = integrateDfg(cosines.x, surface.z);
}
