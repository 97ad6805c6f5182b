// Marks the pixels that need a ray, in a pass with one group for 8 x 8 pixels. trace/list makes the list from the
// marks.
#ifndef GLINT_TRACE_RAY_LIST_GLSL
#define GLINT_TRACE_RAY_LIST_GLSL

#extension GL_KHR_shader_subgroup_arithmetic : require

#include "shared/trace_constants.h"

layout(scalar, set = 0, binding = 10) buffer RayTilesBlock {
    uvec2 masks[]; // a bit a pixel of the tile, row by row; zeroed
}
rayTiles;
layout(scalar, set = 0, binding = 11) buffer RayBlocksBlock {
    // Of kTilesPerBlock tiles each: rays in the low half, kFromRough if any of them starts on a rough surface; zeroed.
    // Sums and flags, so the order of additions does not show.
    uint counts[];
}
rayBlocks;

/// The invocations of a subgroup that need a ray add their bits together, whichever pixels of the tile they have: a
/// barrier for whole groups costs software devices more than the rest of such a pass.
void needRay(bool needsRay, bool fromRough) {
    if (!needsRay)
        return;
    uint bit = 1u << (gl_LocalInvocationIndex & 31u);
    bool low = gl_LocalInvocationIndex < 32u;
    uvec2 mask = subgroupOr(uvec2(low ? bit : 0u, low ? 0u : bit));
    uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (subgroupElect()) { // of those whose bits are in the mask: before any other branch
        if (mask.x != 0u)
            atomicOr(rayTiles.masks[tile].x, mask.x);
        if (mask.y != 0u)
            atomicOr(rayTiles.masks[tile].y, mask.y);
        atomicAdd(rayBlocks.counts[tile / kTilesPerBlock], uint(bitCount(mask.x) + bitCount(mask.y)));
    }
    if (fromRough) {
        if (subgroupElect())
            atomicOr(rayBlocks.counts[tile / kTilesPerBlock], kFromRough);
    }
}

#endif
