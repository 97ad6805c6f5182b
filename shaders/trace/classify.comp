// Finds the pixels that need a ray and lists them, neighbours by neighbours, so that tracing runs over full groups and
// costs nothing where there is nothing to reflect. The other pixels get their answer here.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/camera.glsl"
#include "lib/fades.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
}
frame;
layout(set = 0, binding = 1) uniform sampler2D viewZ;
layout(set = 0, binding = 2) uniform usampler2D surface;
layout(push_constant, scalar) uniform PushBlock {
    TraceConstants settings;
};

#include "trace/ray_list.glsl"
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

void listBegins() { // somebody needs what rays look at
    ivec2 tiles = (ivec2(frame.constants.size) + int(kPyramidTile) - 1) / int(kPyramidTile);
    rays.header.pyramidGroups[0] = uint(tiles.x);
    rays.header.pyramidGroups[1] = uint(tiles.y);
    rays.header.backFaceGroups[0] = settings.backFaceGroups.x;
    rays.header.backFaceGroups[1] = settings.backFaceGroups.y;
}

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    if (isTracePixel(frame.constants, tracePX)) {
        ivec2 px = tracePixelToFull(frame.constants, tracePX);
        vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
        RayRecord record = RayRecord(uv, 0.0, 0u, kOutcomeNone, false);
        float z = texelFetch(viewZ, px, 0).r;
        if (z < kBackgroundZ) {
            record.outcome = whyNoRay(z, unpackSurface(texelFetch(surface, px, 0).xy), uv);
            needsRay = record.outcome == kOutcomeNone;
        }
        if (!needsRay)
            storeTraced(tracePX, vec3(0.0), 0.0, record);
    }
    listRay(needsRay, tracePX);
}
