// A host's own shading of hits (glint/ray_hits.hpp): the instance, the distance and the side as a colour.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 64) in;

struct RayHit {
    uint pixel;
    float distance;
    uint instance;
    uint primitive;
    vec2 barycentrics;
    uint frontFace;
    float coneWidth;
    vec3 originWS;
    vec3 directionWS;
};

layout(scalar, set = 0, binding = 0) readonly buffer ArgumentsBlock {
    uvec3 groups;
    uint count;
} arguments;
layout(scalar, set = 0, binding = 1) readonly buffer HitsBlock {
    RayHit item[];
} hits;
layout(set = 0, binding = 2, rgba16f) uniform writeonly image2D answer;

void main() {
    uint index = gl_WorkGroupID.y * 4096u + gl_WorkGroupID.x * 64u + gl_LocalInvocationIndex;
    if (index >= arguments.count)
        return;
    RayHit hit = hits.item[index];
    ivec2 px = ivec2(hit.pixel & 0xffffu, hit.pixel >> 16);
    if (hit.instance != 0xffffffffu) // pixels without an answer were cleared
        imageStore(answer, px, vec4(float(hit.instance), hit.distance / 100.0, float(hit.frontFace), 1.0));
}
