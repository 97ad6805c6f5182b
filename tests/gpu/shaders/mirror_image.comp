// denoise/mirror_image.glsl for the test's arguments.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "denoise/mirror_image.glsl"

layout(local_size_x = 64) in;

struct Item {
    MirrorPlace mirror;
    float distance;
    vec3 step;
    vec3 eyeBefore;
    vec3 image;
    uint seen;
};

layout(scalar, set = 0, binding = 0) buffer ItemBlock {
    Item list[];
} items;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(items.list.length()))
        return;
    Item item = items.list[i];
    vec3 image = vec3(0.0);
    bool seen = mirrorImage(item.mirror, item.distance, 1.0, item.step, item.eyeBefore, image);
    items.list[i].image = image;
    items.list[i].seen = seen ? 1u : 0u;
}
