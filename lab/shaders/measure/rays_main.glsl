// Traces a list of rays to their nearest hits, for timing.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/back_end.glsl"

layout(local_size_x = 64) in;

layout(scalar, set = 0, binding = 0) readonly buffer RaysBlock {
    Ray item[];
} rays;
layout(scalar, set = 0, binding = 1) writeonly buffer HitsBlock {
    Hit item[];
} hits;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < rays.item.length())
        hits.item[i] = traceRay(rays.item[i]);
}
