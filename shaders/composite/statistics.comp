// Counts the outcomes of the frame's rays and the depth lookups of each ray. Runs only on request.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/ray_record.glsl"
#include "lib/trace_pixel.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform usampler2D rayRecord;
layout(scalar, set = 0, binding = 2) buffer StatisticsBlock {
    RayStatistics counts;
} statistics;

void main() {
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (!isTracePixel(frame.constants, px))
        return;
    RayRecord ray = unpackRayRecord(texelFetch(rayRecord, px, 0).xy);
    atomicAdd(statistics.counts.outcomes[ray.outcome], 1u);
    bool traced = ray.outcome != kOutcomeNone && ray.outcome < kOutcomeBelowThreshold;
    if (traced)
        atomicAdd(statistics.counts.lookups[ray.lookups], 1u);
}
