// Writes rays' hits for a host that shades them: one ray for each listed pixel. docs/techniques/ray-reflections.md.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/back_end.glsl"

#include "rays/pixel_rays.glsl"
#include "shared/ray_hit.h"

#include "rays/after_screen.glsl"

layout(local_size_x = 64) in; // kRaysPerGroup

layout(set = 0, binding = 8, rgba32ui) uniform writeonly uimage2D raysRecord;
layout(scalar, set = 0, binding = 9) writeonly buffer HitsBlock {
    RayHitRecord item[];
}
hits;

void main() {
    uint index = listedRay();
    if (index >= rays.header.rayCount)
        return;
    PixelRays from = loadPixelRays(index);
    Direction direction = samplePixel(from, 0u);
    if (direction.weight <= 0.0)
        direction.ws = reflect(-from.V, from.N);
    Ray ray = viewRay(from.originWS, direction.ws);
    Hit hit = traceRay(ray);
    bool met = isHit(hit);
    RayHitRecord item;
    item.pixel = uint(from.px.x) | (uint(from.px.y) << 16);
    item.distance = hit.distance;
    item.instance = hit.instance;
    item.primitive = hit.primitive;
    item.barycentrics = hit.barycentrics;
    item.frontFace = hit.frontFace ? 1u : 0u;
    item.coneWidth = from.cone.width + from.cone.spread * (met ? hit.distance : 0.0);
    item.originWS = ray.originWS;
    item.directionWS = ray.directionWS;
    hits.item[index] = item;
    RayRecord record = RayRecord(met ? projectedUV(ray.originWS + ray.directionWS * hit.distance) : from.uv,
                                 met ? hit.distance : 0.0, 1u, met ? kOutcomeHit : kOutcomeSky, false);
    imageStore(raysRecord, from.px,
               uvec4(packRayRecord(record), takesBack(screenRay(from.px)) ? kRaysReplaceScreen : 0u, 0u));
}
