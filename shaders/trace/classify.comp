// Finds the pixels that need a ray; list.comp lists them. Tracing costs nothing where nothing reflects. The other
// pixels get their answer here.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "generate/lobe.glsl"
#include "generate/pixel_ray.glsl"
#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/fades.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 12) uniform sampler2D rayRates;
TraceConstants settings = frame.settings.trace;

#include "denoise/ray_rate.glsl"
#include "trace/ray_list.glsl"
#include "trace/traced.glsl"

/// Returns kOutcomeNone where a ray is needed.
uint whyNoRay(ivec2 px, float z, Surface here, vec2 uv) {
    if (here.reflectivity <= settings.threshold)
        return kOutcomeBelowThreshold;
    if (fadeRoughness(here.perceptualRoughness, settings.roughnessFadeStart, settings.maxRoughness) <= 0.0)
        return kOutcomeTooRough;
    if ((settings.flags & kFadeFacingCamera) != 0u) {
        PixelRay ray = generateRay(uv, z, here);
        if (fadeFacingCamera(dot(-viewDirection(frame.constants, ray.originVS), ray.directionVS)) <= 0.0)
            return kOutcomeFacingCamera;
    }
    return sendsRay(px, here.perceptualRoughness) ? kOutcomeNone : kOutcomeFromNeighbours;
}

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    bool needsRay = false;
    bool fromRough = false; // asked for cones alone
    if (isTracePixel(frame.constants, tracePX)) {
        ivec2 px = tracePixelToFull(frame.constants, tracePX);
        vec2 uv = (vec2(px) + 0.5) * frame.constants.invSize;
        RayRecord record = RayRecord(uv, 0.0, 0u, kOutcomeNone, false);
        float z = texelFetch(viewZ, px, 0).r;
        if (z < kBackgroundZ) {
            Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
            record.outcome = whyNoRay(px, z, here, uv);
            needsRay = record.outcome == kOutcomeNone;
            fromRough = (settings.flags & kTraceCones) != 0u && !isMirror(here.perceptualRoughness);
        }
        if (!needsRay)
            storeTraced(tracePX, vec3(0.0), 0.0, record);
    }
    needRay(needsRay, fromRough);
}
