// Counts the outcomes of the frame's rays and the depth lookups of each ray. Runs only on request. Each group counts a
// square of 64 x 64 pixels in its own memory: thousands of pixels have the same outcome, and the device would add them to
// one word of the buffer one after the other.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/ray_record.glsl"
#include "lib/trace_pixel.glsl"

const uint kSide = 16u; // pixels that the group visits at once

layout(local_size_x = kSide, local_size_y = kSide) in;

layout(set = 0, binding = 1) uniform usampler2D rayRecord;
layout(scalar, set = 0, binding = 2) buffer StatisticsBlock {
    RayStatistics counts;
} statistics;

const uint kFewLookups = kSide * kSide - kOutcomeCount; // as most rays take

shared uint groupOutcomes[kOutcomeCount];
shared uint groupLookups[kFewLookups];

void count(ivec2 px) {
    RayRecord ray = unpackRayRecord(texelFetch(rayRecord, px, 0).xy);
    atomicAdd(groupOutcomes[ray.outcome], 1u);
    bool traced = ray.outcome != kOutcomeNone && ray.outcome < kOutcomeBelowThreshold;
    if (!traced)
        return;
    if (ray.lookups < kFewLookups)
        atomicAdd(groupLookups[ray.lookups], 1u);
    else
        atomicAdd(statistics.counts.lookups[ray.lookups], 1u);
}

void main() {
    uint thread = gl_LocalInvocationIndex; // one for each of the group's counters
    if (thread < kOutcomeCount)
        groupOutcomes[thread] = 0u;
    else
        groupLookups[thread - kOutcomeCount] = 0u;
    barrier();
    ivec2 first = ivec2(gl_WorkGroupID.xy) * int(kCountedSquare) + ivec2(gl_LocalInvocationID.xy);
    for (int y = 0; y < int(kCountedSquare); y += int(kSide))
        for (int x = 0; x < int(kCountedSquare); x += int(kSide))
            if (isTracePixel(frame.constants, first + ivec2(x, y)))
                count(first + ivec2(x, y));
    barrier();
    if (thread < kOutcomeCount) {
        if (groupOutcomes[thread] > 0u)
            atomicAdd(statistics.counts.outcomes[thread], groupOutcomes[thread]);
    } else if (groupLookups[thread - kOutcomeCount] > 0u) {
        atomicAdd(statistics.counts.lookups[thread - kOutcomeCount], groupLookups[thread - kOutcomeCount]);
    }
}
