// Counts the work of the source `rays`. Runs only on request.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/frame_block.glsl"
#include "lib/ray_record.glsl"
#include "shared/rays_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 1) uniform usampler2D raysRecord;
layout(scalar, set = 0, binding = 2) buffer StatisticsBlock {
    RayStatistics counts;
}
statistics;

shared uint groupPixels;
shared uint groupRays;
shared uint groupFromScreen;
shared uint groupReplaced;
shared uint groupReused;

void addWide(uint amount, bool isRays) {
    uint before = isRays ? atomicAdd(statistics.counts.sceneRays[0], amount)
                         : atomicAdd(statistics.counts.reusedLight[0], amount);
    if (before + amount >= before)
        return;
    if (isRays)
        atomicAdd(statistics.counts.sceneRays[1], 1u);
    else
        atomicAdd(statistics.counts.reusedLight[1], 1u);
}

void main() {
    if (gl_LocalInvocationIndex == 0u)
        groupPixels = groupRays = groupFromScreen = groupReplaced = groupReused = 0u;
    barrier();
    ivec2 px = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(px, ivec2(frame.constants.size)))) {
        uvec4 stored = texelFetch(raysRecord, px, 0);
        RayRecord ray = unpackRayRecord(stored.xy);
        bool fromScreen = (stored.z & kRaysStartOnScreen) != 0u;
        if (ray.lookups > 0u || fromScreen) {
            atomicAdd(groupPixels, 1u);
            atomicAdd(groupRays, ray.lookups);
            atomicAdd(groupFromScreen, fromScreen ? 1u : 0u);
            atomicAdd(groupReplaced, (stored.z & kRaysReplaceScreen) != 0u ? 1u : 0u);
            atomicAdd(groupReused, stored.z & kRaysReusedMask);
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u && groupPixels > 0u) {
        atomicAdd(statistics.counts.scenePixels, groupPixels);
        atomicAdd(statistics.counts.fromScreen, groupFromScreen);
        atomicAdd(statistics.counts.replaced, groupReplaced);
        addWide(groupRays, true);
        addWide(groupReused, false);
    }
}
