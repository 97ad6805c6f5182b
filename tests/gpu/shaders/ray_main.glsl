// Traces a list of rays through the scene, both ways. tests/gpu/ray_scene_test.cpp.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "ray_alpha.glsl"

#include "rays/back_end.glsl"

layout(local_size_x = 64) in;

struct TestHit {
    Hit hit;
    uint occluded;
};
layout(scalar, set = 0, binding = 0) readonly buffer RaysBlock {
    Ray item[];
} rays;
layout(scalar, set = 0, binding = 1) writeonly buffer HitsBlock {
    TestHit item[];
} hits;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.item.length())
        return;
    Ray ray = rays.item[i];
    Hit hit = traceRay(ray);
    hits.item[i].hit = hit;
    hits.item[i].occluded = isOccluded(ray) ? 1u : 0u;
}
