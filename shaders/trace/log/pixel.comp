// Logs the inspected pixel: its surface, what the frame found for it, and its ray, if any, as a list of one.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/ray_record.glsl"
#include "lib/resolved_material.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"
#include "shared/ray_log.h"
#include "shared/trace_constants.h"

layout(local_size_x = 1) in;

layout(set = 0, binding = 3) uniform sampler2D material;
layout(set = 0, binding = 4) uniform usampler2D rayRecord;
layout(set = 0, binding = 5) uniform sampler2D reflected;
layout(set = 0, binding = 6) uniform sampler2D composite;
layout(scalar, set = 0, binding = 10) writeonly buffer RaysBlock {
    RayListHeader header;
    uint pixels[];
} rays;
layout(scalar, set = 0, binding = 13) writeonly buffer LogBlock { // zeroed
    RayLogHeader header;
} rayLog;
layout(push_constant, scalar) uniform PushBlock {
    InspectConstants settings;
};

void main() {
    ivec2 px = ivec2(settings.px);
    ivec2 tracePX = fullToTracePixel(frame.constants, px);
    float z = texelFetch(viewZ, px, 0).r;
    bool background = z >= kBackgroundZ;
    uvec2 record = texelFetch(rayRecord, tracePX, 0).xy;
    uint outcome = background ? kOutcomeNone : unpackRayRecord(record).outcome;
    bool traced = outcome != kOutcomeNone && outcome < kOutcomeBelowThreshold;

    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    vec3 positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    LoggedPixel pixel;
    pixel.px = uvec2(px);
    pixel.rayPX = uvec2(tracePixelToFull(frame.constants, tracePX));
    pixel.outcome = outcome;
    pixel.record = record;
    pixel.viewZ = z;
    pixel.positionVS = background ? vec3(0.0) : positionVS;
    pixel.positionWS = background ? vec3(0.0) : (frame.constants.viewToWorld * vec4(positionVS, 1.0)).xyz;
    pixel.normalWS = background ? vec3(0.0) : mat3(frame.constants.viewToWorld) * here.normalVS;
    pixel.f0 = background ? vec3(0.0) : resolvedMaterial(frame.constants, texelFetch(material, px, 0)).rgb;
    pixel.perceptualRoughness = background ? 0.0 : here.perceptualRoughness;
    pixel.reflected = texelFetch(reflected, px, 0);
    pixel.composite = texelFetch(composite, px, 0);
    rayLog.header.pixel = pixel;

    uint count = traced ? 1u : 0u;
    const uint kNone[3] = uint[3](0u, 0u, 1u);
    rays.header = RayListHeader(uint[3](count, count, 1u), count, kNone, kNone, kNone);
    rays.pixels[0] = uint(tracePX.x) | (uint(tracePX.y) << 16);
}
