// Where a ray starts, so that it does not meet the surface that it leaves: as far off as the position is uncertain,
// which scales with the scene. No length in metres stands here.
#ifndef GLINT_LIB_RAY_START_GLSL
#define GLINT_LIB_RAY_START_GLSL

#include "lib/math.glsl"

/// A point that was interpolated from vertices and moved into the world: some roundings of its largest coordinate.
/// After Waechter and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems 1, ch.
/// 6, without its absolute bound about the origin.
float hitUncertainty(vec3 positionWS) {
    return maxComponent(abs(positionWS)) * exp2(-18.0);
}

/// A point that the rasterizer interpolated: a few roundings more.
float rasterUncertainty(vec3 positionWS) {
    return maxComponent(abs(positionWS)) * exp2(-16.0);
}

/// A point that was made from depth: rasterizers interpolate depth with roundings of the nearest vertex's, and a host's
/// halfs keep eleven bits of it.
float depthUncertainty(vec3 positionWS, float viewZ, bool halfDepth) {
    return max(hitUncertainty(positionWS), viewZ * exp2(halfDepth ? -10.0 : -16.0));
}

/// A direction that leaves the side of a surface on which `faceNormalWS` stands: one that a bent normal sends below is
/// laid along the surface instead. Both unit.
vec3 aboveSurface(vec3 directionWS, vec3 faceNormalWS) {
    const float kLeast = 0.01; // cosine
    float cosine = dot(directionWS, faceNormalWS);
    return cosine >= kLeast ? directionWS : normalizeOr(directionWS + faceNormalWS * (kLeast - cosine), faceNormalWS);
}

#endif
