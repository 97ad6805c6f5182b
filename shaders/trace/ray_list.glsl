// Rays, listed by those who find that a pixel needs one: neighbours by neighbours, so that tracing runs over full
// groups. Which place a ray gets may change from run to run; nothing depends on it, nor on a subgroup's size. Call
// takePlace from every invocation of the entry, which defines what else the first ray of all needs:
//     void listBegins();
#ifndef GLINT_TRACE_RAY_LIST_GLSL
#define GLINT_TRACE_RAY_LIST_GLSL

#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/trace_constants.h"

layout(constant_id = 0) const bool kSubgroups = true; // off: an atomic a ray, for the same rays

layout(scalar, set = 0, binding = 10) buffer RaysBlock { // its header zeroed but for the group counts that stay 1
    RayListHeader header;
    uint pixels[];
}
rays;

void listBegins();

/// Room for `count` rays in the list: the first one's place. Whoever fills a row of groups first has it dispatched.
uint takePlaces(uint count) {
    const uint kRowRays = kRaysPerGroup * kRayGroupsX;
    uint first = atomicAdd(rays.header.rayCount, count);
    if (first % kRowRays == 0u || first / kRowRays != (first + count - 1u) / kRowRays)
        atomicMax(rays.header.rayGroups[1], (first + count - 1u) / kRowRays + 1u);
    if (first == 0u)
        listBegins();
    return first;
}

/// The place of this invocation's ray.
uint takePlace(bool needsRay) {
    if (!kSubgroups)
        return needsRay ? takePlaces(1u) : 0u;
    uvec4 wanting = subgroupBallot(needsRay);
    uint count = subgroupBallotBitCount(wanting);
    uint first = 0u;
    if (count > 0u && subgroupElect())
        first = takePlaces(count);
    return subgroupBroadcastFirst(first) + subgroupBallotExclusiveBitCount(wanting);
}

void listRay(bool needsRay, ivec2 px) {
    uint place = takePlace(needsRay);
    if (needsRay)
        rays.pixels[place] = uint(px.x) | (uint(px.y) << 16);
}

#endif
