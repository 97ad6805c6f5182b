// The pixels that the passes of `resolve` mix: where each one's surface is, and how similar two surfaces are. Include
// after `rayRecord`.
#ifndef GLINT_RESOLVE_NEIGHBOURHOOD_GLSL
#define GLINT_RESOLVE_NEIGHBOURHOOD_GLSL

#include "frame/prepared.glsl"
#include "lib/camera.glsl"
#include "lib/math.glsl"
#include "lib/ray_record.glsl"
#include "lib/surface.glsl"
#include "lib/trace_pixel.glsl"

/// The surface that one pixel of the frame shows.
struct Place {
    vec3 positionVS;
    vec3 normalVS;
    float perceptualRoughness;
    float reflectivity;
    float metresPerPixel; // across the line of sight
    bool background;
};

Place placeOf(ivec2 px) {
    float z = texelFetch(viewZ, px, 0).r;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    Place place;
    place.background = z >= kBackgroundZ;
    place.positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    place.normalVS = here.normalVS;
    place.perceptualRoughness = here.perceptualRoughness;
    place.reflectivity = here.reflectivity;
    place.metresPerPixel = pixelExtent(frame.constants, frame.constants.uvToView, z).y;
    return place;
}

/// 1 where `other` continues the surface of `here`; 0 across an edge of depth, a crease or a change of roughness.
/// `pixels`: their distance on screen. How far a surface may leave the other's plane grows with that distance: a
/// silhouette leaves the plane at once, a curved or bumpy surface by little.
float sameSurface(Place here, Place other, float pixels) {
    if (other.background)
        return 0.0;
    vec3 between = other.positionVS - here.positionVS;
    float fromPlane = min(abs(dot(here.normalVS, between)), abs(dot(other.normalVS, between)));
    float allowed = here.metresPerPixel * (0.25 + 0.5 * pixels) + 0.05 * length(between);
    float plane = 1.0 - smoothstep(allowed, 2.0 * allowed, fromPlane);
    float normal = square(square(square(square(clamp(dot(here.normalVS, other.normalVS), 0.0, 1.0)))));
    float roughness = max(1.0 - 5.0 * abs(here.perceptualRoughness - other.perceptualRoughness), 0.0);
    return plane * normal * roughness;
}

RayRecord rayOf(ivec2 tracePX) {
    return unpackRayRecord(texelFetch(rayRecord, tracePX, 0).xy);
}

/// True if a ray started here. Background and surfaces that do not reflect have no answer, which is not a black answer.
bool wasTraced(RayRecord ray) {
    return ray.outcome != kOutcomeNone && ray.outcome < kOutcomeBelowThreshold;
}

/// Each pixel of an image of `gridSize`, which covers the whole frame, stands for one traced pixel.
ivec2 gridToTracePixel(vec2 gridSize, ivec2 gridPX) {
    vec2 at = (vec2(gridPX) + 0.5) * (frame.constants.traceSize / gridSize);
    return min(floorToInt(at), ivec2(frame.constants.traceSize) - 1);
}

#endif
