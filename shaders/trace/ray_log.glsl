// What a march looks at and why, for the inspector: the entry shaders of trace/log define GLINT_RAY_LOG and march one
// ray with the very code of the frame. Without it every function here is empty. Include after `viewZ`,
// Ray and March.
#ifndef GLINT_TRACE_RAY_LOG_GLSL
#define GLINT_TRACE_RAY_LOG_GLSL

#include "lib/ray_record.glsl"
#include "shared/ray_log.h"

#ifdef GLINT_RAY_LOG

#include "lib/nearness.glsl"

layout(scalar, set = 0, binding = 13) buffer LogBlock {
    RayLogHeader header;
    LoggedSample samples[]; // kMaxLoggedSamples
}
rayLog;

/// One depth read of a pixel.
void logSample(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {
    uint i = rayLog.header.sampleCount++;
    if (i < kMaxLoggedSamples)
        rayLog.samples[i] = LoggedSample(px, 0u, rayZ, sceneZ, 0.0, rayDistance(ray, share),
                                         rayZ < sceneZ ? kSampleFront : kSampleBehind);
}

/// The newest sample of this very place; kMaxLoggedSamples if it was not written.
uint findSample(vec2 px) {
    for (uint i = min(rayLog.header.sampleCount, kMaxLoggedSamples); i > 0u; --i)
        if (rayLog.samples[i - 1u].level == 0u && rayLog.samples[i - 1u].px == px)
            return i - 1u;
    return kMaxLoggedSamples;
}

/// What came of it.
void logDecision(vec2 px, uint decision) {
    uint i = findSample(px);
    if (i < kMaxLoggedSamples)
        rayLog.samples[i].decision = decision;
}

/// viewZ to which the surface there reaches back.
void logSlab(vec2 px, float slabZ) {
    uint i = findSample(px);
    if (i < kMaxLoggedSamples)
        rayLog.samples[i].slabZ = slabZ;
}

/// The neighbour of a hit, asked whether it shows the same surface.
void logPlace(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {
    logSample(ray, share, px, rayZ, sceneZ);
    if (rayLog.header.sampleCount <= kMaxLoggedSamples)
        rayLog.samples[rayLog.header.sampleCount - 1u].decision = kSamplePlaces;
}

/// One read of a cell; `nearness` of its plane where the ray enters it, `slab` as lib/pyramid.glsl has it.
void logCell(ScreenRay ray, float share, ivec2 cell, int level, float nearness, float slab, uint decision) {
    uint i = rayLog.header.sampleCount++;
    if (i >= kMaxLoggedSamples)
        return;
    vec2 low = vec2(cell << level);
    vec2 px = clamp(ray.startPX + ray.deltaPX * share, low, low + float(1 << level) - 0.001);
    float sceneZ = decision == kSampleEmpty ? kBackgroundZ : viewZOf(frame.constants, nearness);
    float slabZ = decision == kSampleEmpty ? 0.0 : viewZOf(frame.constants, nearness - slab);
    rayLog.samples[i] =
        LoggedSample(px, uint(level), rayViewZ(ray, share), sceneZ, slabZ, rayDistance(ray, share), decision);
}

/// What came of the newest cell.
void logCellDecision(uint decision) {
    if (rayLog.header.sampleCount > kMaxLoggedSamples)
        return;
    for (uint i = rayLog.header.sampleCount; i > 0u; --i)
        if (rayLog.samples[i - 1u].level > 0u) {
            rayLog.samples[i - 1u].decision = decision;
            return;
        }
}

float logFade(uint fade, float factor) {
    rayLog.header.ray.fadesUsed |= 1u << fade;
    rayLog.header.ray.fades[fade] = factor;
    return factor;
}

/// What march proxy takes the ray to meet: a probe's number, the shape of its proxy, how far that is.
void logProjection(uint probe, uint shape, float distance) {
    rayLog.header.ray.projected = 1u;
    rayLog.header.ray.probe = probe;
    rayLog.header.ray.proxyShape = shape;
    rayLog.header.ray.projectionDistance = distance;
}

/// How it all ended, and what that is worth.
void logRay(Ray ray, March end, vec2 endPX, RayRecord record, bool answered, vec4 answer) {
    LoggedRay logged = rayLog.header.ray; // with the fades and the projection
    logged.traced = 1u;
    logged.answered = answered ? 1u : 0u;
    logged.record = packRayRecord(record);
    vec3 endVS = ray.originVS + ray.directionVS * record.hitDistance;
    mat4 viewToWorld = frame.constants.viewToWorld;
    logged.startVS = ray.originVS;
    logged.startWS = (viewToWorld * vec4(ray.originVS, 1.0)).xyz;
    logged.directionVS = ray.directionVS;
    logged.directionWS = mat3(viewToWorld) * ray.directionVS;
    logged.lengthVS = ray.screen.lengthVS;
    logged.startPX = ray.screen.startPX;
    logged.endPX = endPX;
    logged.endVS = endVS;
    logged.endWS = (viewToWorld * vec4(endVS, 1.0)).xyz;
    logged.startZ = rayViewZ(ray.screen, 0.0);
    logged.endZ = rayViewZ(ray.screen, end.share);
    logged.endDistance = record.hitDistance;
    logged.hitZ = onScreen(endPX) ? texelFetch(viewZ, ivec2(endPX), 0).r : kBackgroundZ;
    logged.radiance = answer.rgb;
    logged.weight = answer.a;
    logged.lookups = end.lookups;
    logged.iterations = end.iterations;
    rayLog.header.ray = logged;
}

#else

void logSample(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {}
void logDecision(vec2 px, uint decision) {}
void logSlab(vec2 px, float slabZ) {}
void logPlace(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {}
void logCell(ScreenRay ray, float share, ivec2 cell, int level, float nearness, float slab, uint decision) {}
void logCellDecision(uint decision) {}
float logFade(uint fade, float factor) {
    return factor;
}
void logProjection(uint probe, uint shape, float distance) {}
void logRay(Ray ray, March end, vec2 endPX, RayRecord record, bool answered, vec4 answer) {}

#endif
#endif
