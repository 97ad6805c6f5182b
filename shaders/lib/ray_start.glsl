// Where a ray starts, so that it does not hit the surface that it leaves: offset by the uncertainty of the position,
// which scales with the scene. No constant here is a length in metres.
#ifndef GLINT_LIB_RAY_START_GLSL
#define GLINT_LIB_RAY_START_GLSL

#include "lib/math.glsl"

/// For a point interpolated from vertices and transformed to world space: some roundings of its largest coordinate.
/// After Waechter and Binder 2019, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems 1, ch.
/// 6, without its absolute bound about the origin.
float hitUncertainty(vec3 positionWS) {
    return maxComponent(abs(positionWS)) * exp2(-18.0);
}

/// For a point that the rasterizer interpolated: a few roundings more.
float rasterUncertainty(vec3 positionWS) {
    return maxComponent(abs(positionWS)) * exp2(-16.0);
}

/// For a point reconstructed from depth: rasterizers interpolate depth with roundings of the nearest vertex's depth,
/// and a host's halfs keep eleven bits of it.
float depthUncertainty(vec3 positionWS, float viewZ, bool halfDepth) {
    return max(hitUncertainty(positionWS), viewZ * exp2(halfDepth ? -10.0 : -16.0));
}

/// Cosine above which aboveSurface keeps a direction as it is.
const float kLeastCosine = 0.01;

/// Keeps a direction on the side of a surface to which `faceNormalWS` points: a direction that a bent normal sends
/// below the surface is laid along it instead. Both unit.
vec3 aboveSurface(vec3 directionWS, vec3 faceNormalWS) {
    float cosine = dot(directionWS, faceNormalWS);
    return cosine >= kLeastCosine
               ? directionWS
               : normalizeOr(directionWS + faceNormalWS * (kLeastCosine - cosine), faceNormalWS);
}

#endif
