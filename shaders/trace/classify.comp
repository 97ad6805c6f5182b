// Finds the pixels that need a ray and lists them, neighbours by neighbours, so that tracing runs over full groups and
// costs nothing where there is nothing to reflect. The other pixels get their answer here.
// Which place in the list a ray gets may change from run to run; nothing depends on it, nor on a subgroup's size.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "lib/camera.glsl"
#include "lib/fades.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kSubgroups = true; // off: an atomic a ray, for the same rays

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
} frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(scalar, set = 0, binding = 10) buffer RaysBlock { // its header zeroed but for the group counts that stay 1
    RayListHeader header;
    uint pixels[];
} rays;
layout(push_constant, scalar) uniform PushBlock {
    TraceConstants settings;
};

#include "trace/traced.glsl"

/// kOutcomeNone where a ray is needed.
uint whyNoRay(float z, Surface here, vec2 uv) {
    if (here.reflectivity <= settings.threshold)
        return kOutcomeBelowThreshold;
    if (fadeRoughness(here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness) <= 0.0)
        return kOutcomeTooRough;
    if ((settings.flags & kFadeFacingCamera) != 0u) {
        vec3 toSurfaceVS = viewDirection(frame.constants, viewPosition(frame.constants, uv, z));
        if (fadeFacingCamera(dot(-toSurfaceVS, reflect(toSurfaceVS, here.normalVS))) <= 0.0)
            return kOutcomeFacingCamera;
    }
    return kOutcomeNone;
}

/// Room for `count` rays in the list: the first one's place. Whoever fills a row of groups first has it dispatched.
uint takePlaces(uint count) {
    const uint kRowRays = kRaysPerGroup * kRayGroupsX;
    uint first = atomicAdd(rays.header.rayCount, count);
    if (first % kRowRays == 0u || first / kRowRays != (first + count - 1u) / kRowRays)
        atomicMax(rays.header.rayGroups[1], (first + count - 1u) / kRowRays + 1u);
    if (first == 0u) { // somebody needs what rays look at
        ivec2 tiles = (ivec2(frame.constants.size) + int(kPyramidTile) - 1) / int(kPyramidTile);
        rays.header.pyramidGroups[0] = uint(tiles.x);
        rays.header.pyramidGroups[1] = uint(tiles.y);
        rays.header.backFaceGroups[0] = settings.backFaceGroups.x;
        rays.header.backFaceGroups[1] = settings.backFaceGroups.y;
    }
    return first;
}

/// The place of this invocation's ray; call from every invocation.
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

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    if (isTracePixel(frame.constants, tracePX)) {
        ivec2 px = tracePixelToFull(frame.constants, tracePX);
        vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
        RayRecord record = RayRecord(uv, 0.0, 0u, kOutcomeNone);
        float z = texelFetch(viewZ, px, 0).r;
        if (z < kBackgroundZ) {
            record.outcome = whyNoRay(z, unpackSurface(texelFetch(surface, px, 0).xy), uv);
            needsRay = record.outcome == kOutcomeNone;
        }
        if (!needsRay)
            storeTraced(tracePX, vec3(0.0), 0.0, record);
    }

    uint place = takePlace(needsRay);
    if (needsRay)
        rays.pixels[place] = uint(tracePX.x) | (uint(tracePX.y) << 16);
}
