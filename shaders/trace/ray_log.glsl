// Logs what a march samples and decides, for the inspector. The variants in trace/log define GLINT_RAY_LOG and march
// one ray with the same code as the frame. Without GLINT_RAY_LOG every function here is empty. Part of trace/ray.glsl.
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

/// Logs one depth sample of a pixel.
void logSample(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {
    uint i = rayLog.header.sampleCount++;
    if (i < kMaxLoggedSamples)
        rayLog.samples[i] = LoggedSample(px, 0u, rayZ, sceneZ, 0.0, rayDistance(ray, share),
                                         rayZ < sceneZ ? kSampleFront : kSampleBehind);
}

/// The newest sample at this exact place; kMaxLoggedSamples if it was not logged.
uint findSample(vec2 px) {
    for (uint i = min(rayLog.header.sampleCount, kMaxLoggedSamples); i > 0u; --i)
        if (rayLog.samples[i - 1u].level == 0u && rayLog.samples[i - 1u].px == px)
            return i - 1u;
    return kMaxLoggedSamples;
}

/// Logs the decision about a sample.
void logDecision(vec2 px, uint decision) {
    uint i = findSample(px);
    if (i < kMaxLoggedSamples)
        rayLog.samples[i].decision = decision;
}

/// Logs the viewZ to which the surface there reaches back.
void logSlab(vec2 px, float slabZ) {
    uint i = findSample(px);
    if (i < kMaxLoggedSamples)
        rayLog.samples[i].slabZ = slabZ;
}

/// Logs one depth sample of a pixel that the ray need not pass, with the reason why it was read.
void logOther(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ, uint decision) {
    logSample(ray, share, px, rayZ, sceneZ);
    if (rayLog.header.sampleCount <= kMaxLoggedSamples)
        rayLog.samples[rayLog.header.sampleCount - 1u].decision = decision;
}

/// Logs the neighbour of a hit, tested for the same surface.
void logPlace(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {
    logOther(ray, share, px, rayZ, sceneZ, kSamplePlaces);
}

/// Logs a pixel beside an occluder, tested for the surface that a ray crossed behind it.
void logBeside(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {
    logOther(ray, share, px, rayZ, sceneZ, kSampleBeside);
}

/// Logs one read of a cell. `nearness`: of the cell's plane where the ray enters the cell. `slab`: as in
/// lib/pyramid.glsl.
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

/// Logs the decision about the newest cell.
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

/// Logs the projection that marcher proxy intersects: the probe's number, its proxy's shape, the distance.
void logProjection(uint probe, uint shape, float distance) {
    rayLog.header.ray.projected = 1u;
    rayLog.header.ray.probe = probe;
    rayLog.header.ray.proxyShape = shape;
    rayLog.header.ray.projectionDistance = distance;
}

/// Logs how the ray ended and the weight of its answer.
void logRay(Ray ray, March end, vec2 endPX, RayRecord record, bool answered, vec4 answer) {
    LoggedRay logged = rayLog.header.ray; // already has the fades and the projection
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
    logged.hitZ = onScreen(endPX) ? loadSceneZ(ivec2(endPX)) : kBackgroundZ;
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
void logBeside(ScreenRay ray, float share, vec2 px, float rayZ, float sceneZ) {}
void logCell(ScreenRay ray, float share, ivec2 cell, int level, float nearness, float slab, uint decision) {}
void logCellDecision(uint decision) {}
float logFade(uint fade, float factor) {
    return factor;
}
void logProjection(uint probe, uint shape, float distance) {}
void logRay(Ray ray, March end, vec2 endPX, RayRecord record, bool answered, vec4 answer) {}

#endif
#endif
