// Copies samples of the host's images, as stored, for the check of its declarations (src/reflect/check).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shared/input_check.h"

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef GLINT_MANY_SAMPLES // a pixel, of which the first counts
#define GLINT_HOST_SAMPLER sampler2DMS
#else
#define GLINT_HOST_SAMPLER sampler2D
#endif

layout(set = 0, binding = 0) uniform GLINT_HOST_SAMPLER depth;
layout(set = 0, binding = 1) uniform GLINT_HOST_SAMPLER normal;
layout(set = 0, binding = 2) uniform GLINT_HOST_SAMPLER roughness;
layout(set = 0, binding = 3) uniform sampler2D motion;
layout(set = 0, binding = 4, scalar) writeonly buffer Samples {
    InputSample list[];
} samples;

layout(push_constant, scalar) uniform PushBlock {
    InputSampleConstants settings;
};

void main() {
    uvec2 place = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(place, settings.grid)))
        return;
    ivec2 px = ivec2(1u + settings.stride * place);
    InputSample here;
    here.normal = texelFetch(normal, px, 0);
    here.roughness = texelFetch(roughness, px, 0);
    here.depth[0] = texelFetch(depth, px, 0).r;
    here.depth[1] = texelFetch(depth, px - ivec2(1, 0), 0).r;
    here.depth[2] = texelFetch(depth, px + ivec2(1, 0), 0).r;
    here.depth[3] = texelFetch(depth, px - ivec2(0, 1), 0).r;
    here.depth[4] = texelFetch(depth, px + ivec2(0, 1), 0).r;
    vec3 moved = texelFetch(motion, px, 0).xyz;
    here.motion[0] = moved.x;
    here.motion[1] = moved.y;
    here.motion[2] = moved.z;
    samples.list[place.y * settings.grid.x + place.x] = here;
}
