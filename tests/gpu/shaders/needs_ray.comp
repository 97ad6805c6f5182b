// A pass that marks scattered pixels for rays, for trace/list to list. tests/gpu/ray_list_test.cpp computes the same.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/ray_list.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant, scalar) uniform PushBlock {
    uvec2 size;
    uint percent;
};

void main() {
    uvec2 px = gl_GlobalInvocationID.xy;
    uint number = (px.x * 2654435761u) ^ (px.y * 2246822519u);
    needRay(all(lessThan(px, size)) && (number >> 8) % 100u < percent, px.x % 512u == 16u);
}
