// A direction of a surface's reflection lobe, drawn with the density of visible normals that reflect upwards. Every
// source that samples the lobe draws it here: with the same noise they follow the same ray.
#ifndef GLINT_GENERATE_LOBE_GLSL
#define GLINT_GENERATE_LOBE_GLSL

#include "frame/frame_block.glsl"
#include "lib/camera.glsl"
#include "lib/math.glsl"
#include "lib/sampling.glsl"

/// Below this roughness a lobe is narrower than a pixel.
const float kMirrorRoughness = 0.001;

/// Directions nearer to the surface than this cosine count as below it.
const float kLeastLobeCosine = 1e-4;

struct Direction {
    vec3 ws;      // unit
    float weight; // fraction of the light from there that leaves the facets; 0: below the surface
};

/// Angle between two pixels' lines of sight, radians; orthographic: 0, as they are parallel.
float pixelAngle() {
    return isOrthographic(frame.constants) ? 0.0 : abs(frame.constants.uvToView.y) * frame.constants.invSize.y;
}

/// Half of the GGX normals of a lobe lie within `alpha` of the middle (as a tangent); reflected directions turn twice as
/// far.
float lobeTangent(float perceptualRoughness) {
    return square(perceptualRoughness);
}

/// Width on screen of the lobe's footprint, pixels, along the line to the viewer: how far a pixel at `viewZ` may be
/// whose ray reaches the same place inside the lobe. `nearness`: 1 / metres to where the ray ends; 0: infinitely far.
float lobePixels(float perceptualRoughness, float viewZ, float nearness) {
    const float kWide = 1e4;
    float angle = pixelAngle();
    float widest = angle > 0.0 ? 2.0 * lobeTangent(perceptualRoughness) / angle : kWide;
    return widest / (1.0 + nearness * viewZ);
}

/// True for surfaces whose lobe is narrower than half a pixel wherever the ray ends. They reflect one direction: nothing
/// is sampled, and nothing averaged but what they show of rough surfaces (lib/mirrored.glsl).
bool isMirror(float perceptualRoughness) {
    return perceptualRoughness < kMirrorRoughness || lobePixels(perceptualRoughness, 0.0, 0.0) < 0.5;
}

/// GGX's density of the microfacet normal `h` (local, unit, not normalized over the horizon): without a difference of
/// large numbers, so that narrow lobes keep their shape.
float ggxNormals(vec3 h, float alpha) {
    float a2 = alpha * alpha;
    return a2 / (kPi * square(dot(h.xy, h.xy) + a2 * h.z * h.z));
}

/// Density over solid angle with which sampleLobe draws `wi`; local directions, z along the normal.
float lobeDensity(vec3 wo, vec3 wi, float alpha) {
    return wi.z <= 0.0 ? 0.0 : ggxNormals(normalize(wo + wi), alpha) * reflectedGGXScale(wo.z, alpha);
}

/// The lobe itself, times the cosine, without Fresnel: D G2 / (4 NoV).
float lobeResponse(vec3 wo, vec3 wi, float alpha) {
    return wi.z <= 0.0 ? 0.0 : lobeDensity(wo, wi, alpha) * reflectedGGXWeight(wo.z, wi.z, alpha);
}

/// A rough lobe in its own axes, z along the normal.
struct LobeFrame {
    mat3 axes;
    vec3 wo; // unit, towards the viewer
    float alpha;
};

LobeFrame makeLobeFrame(vec3 N, vec3 V, float perceptualRoughness) {
    mat3 axes = orthonormalBasis(N);
    vec3 wo = V * axes;
    wo.z = max(wo.z, 1e-3); // a bent normal may face away
    return LobeFrame(axes, normalize(wo), square(perceptualRoughness));
}

/// Draws a direction that reflects to `V`. `perceptualRoughness` 0: the mirror direction.
Direction sampleLobe(vec3 N, vec3 V, float perceptualRoughness, vec2 noise) {
    if (perceptualRoughness == 0.0)
        return Direction(reflect(-V, N), 1.0);
    LobeFrame lobe = makeLobeFrame(N, V, perceptualRoughness);
    vec3 wm = sampleGGXReflected(lobe.wo, noise, lobe.alpha);
    vec3 wi = reflect(-lobe.wo, wm);
    if (wi.z <= kLeastLobeCosine)
        return Direction(N, 0.0);
    return Direction(lobe.axes * wi, reflectedGGXWeight(lobe.wo.z, wi.z, lobe.alpha));
}

#endif
