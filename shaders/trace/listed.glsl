// Which pixels are on the ray list, for a pass over the whole picture that reads their answers. With kTraceListedOnly
// the others have none: nothing was stored for them.
#ifndef GLINT_TRACE_LISTED_GLSL
#define GLINT_TRACE_LISTED_GLSL

#include "frame/frame_block.glsl"
#include "shared/trace_constants.h"

layout(scalar, set = 0, binding = 15) readonly buffer RayTilesBlock {
    uvec2 masks[]; // trace/ray_list.glsl
}
rayTiles;

/// True if the invocation's pixel has an answer of the screen's. The groups are the list's tiles, of 8 x 8 pixels.
bool hasTracedAnswer() {
    if ((frame.settings.trace.flags & kTraceListedOnly) == 0u)
        return true;
    uvec2 mask = rayTiles.masks[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x];
    uint pixel = gl_LocalInvocationIndex;
    return ((pixel < 32u ? mask.x : mask.y) >> (pixel & 31u) & 1u) != 0u;
}

#endif
