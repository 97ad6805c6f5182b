// One reflection probe: its weight for a surface, and the direction in which to sample its cube map. Formulas: HDRP's
// LightLoop, InfluenceVolume and VolumeProjection as docs/techniques/probes.md lists them; Lagarde and de Rousiers
// 2014, "Moving Frostbite to Physically Based Rendering", section 4.9.
#ifndef GLINT_LIB_PROBE_GLSL
#define GLINT_LIB_PROBE_GLSL

#include "lib/math.glsl"
#include "shared/probes.h"

/// Transforms a position (w = 1) or direction (w = 0) into a volume's axes.
vec3 intoVolume(vec4 rows[3], vec4 v) {
    return vec3(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
}

float minComponent(vec3 v) {
    return min(v.x, min(v.y, v.z));
}

/// Depth inside the influence volume: 0 at its surface and outside, 1 from the blend distance inward, linear between.
float influenceDepth(ProbeRecord probe, vec3 p) {
    if (probe.influenceShape == kProbeSphere)
        return saturate((probe.influenceExtents.x - length(p)) / probe.blendPos.x);
    vec3 toPos = (probe.influenceExtents - p) / probe.blendPos;
    vec3 toNeg = (probe.influenceExtents + p) / probe.blendNeg;
    return saturate(min(minComponent(toPos), minComponent(toNeg)));
}

/// In the outer layer of blendNormalDistance, the weight of a surface depends on the direction it faces: full weight up
/// to a cosine of -0.2 or more towards the capture position, none from 0.6 away from it on.
float normalFade(ProbeRecord probe, vec3 p, vec3 positionWS, vec3 normalWS) {
    bool inside;
    if (probe.influenceShape == kProbeSphere)
        inside = length(p) <= probe.influenceExtents.x - probe.blendNormalPos.x;
    else
        inside = all(lessThanEqual(p, probe.influenceExtents - probe.blendNormalPos)) &&
                 all(greaterThanEqual(p, probe.blendNormalNeg - probe.influenceExtents));
    if (inside)
        return 1.0;
    vec3 outward = normalizeOr(positionWS - probe.capturePositionWS, vec3(0.0));
    return saturate((0.6 - dot(normalWS, outward)) / 0.4);
}

/// Each face accepts reflections from 75 degrees off its axis and has full weight from 60 on; whole faces sum to 1.
float faceFade(ProbeRecord probe, vec3 direction) {
    vec3 pos = clamp(4.0 * direction - 1.0, 0.0, 1.0) * probe.faceFadePos;
    vec3 neg = clamp(-4.0 * direction - 1.0, 0.0, 1.0) * probe.faceFadeNeg;
    return saturate(dot(pos + neg, vec3(1.0)));
}

/// [0, 1]. `directionWS`: of the reflection, unit.
float probeWeight(ProbeRecord probe, vec3 positionWS, vec3 normalWS, vec3 directionWS) {
    vec3 p = intoVolume(probe.worldToInfluence, vec4(positionWS, 1.0));
    float depth = influenceDepth(probe, p);
    if (depth <= 0.0)
        return 0.0;
    depth *= normalFade(probe, p, positionWS, normalWS) *
             faceFade(probe, intoVolume(probe.worldToInfluence, vec4(directionWS, 0.0)));
    return depth * depth * (3.0 - 2.0 * depth) * probe.weight;
}

/// [0, 1], for all light of an object with this centre.
float probeWeightOfObject(ProbeRecord probe, vec3 centerWS) {
    float depth = influenceDepth(probe, intoVolume(probe.worldToInfluence, vec4(centerWS, 1.0)));
    return smoothstep(0.0, 1.0, depth) * probe.weight;
}

/// Metres along the ray to where it leaves the proxy, >= 0. A ray from outside of a box or past a sphere takes the
/// point nearest to that, so that reflections have no seam at the proxy's faces.
float proxyDistance(ProbeRecord probe, vec3 positionWS, vec3 directionWS) {
    vec3 p = intoVolume(probe.worldToProxy, vec4(positionWS, 1.0));
    vec3 d = intoVolume(probe.worldToProxy, vec4(directionWS, 0.0));
    if (probe.proxyShape == kProbeSphere) {
        float b = dot(d, p);
        float c = dot(p, p) - square(probe.proxyExtents.x);
        return max(sqrt(max(b * b - c, 0.0)) - b, 0.0);
    }
    vec3 wall = mix(-probe.proxyExtents, probe.proxyExtents, greaterThan(d, vec3(0.0)));
    vec3 toWall = (wall - p) / d; // infinite along an axis on which the ray does not move
    toWall = mix(toWall, vec3(1e30), lessThan(abs(d), vec3(1e-7)));
    return max(minComponent(toWall), 0.0);
}

const float kProbeFar = 1e20; // metres: no hit

struct ProbeLookup {
    vec3 directionWS;          // in which to sample the cube
    float perceptualRoughness; // of the mip
    float shown;               // 1 / metres from the capture position to the hit; 0 without one
};

/// Where the cube shows a hit at `surfaceToHit` metres, and the roughness to sample it with. Rays without a hit
/// (infinity) travel as far from the surface as from the capture position.
ProbeLookup probeLookup(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float surfaceToHit,
                        float perceptualRoughness, uint flags) {
    if (surfaceToHit > kProbeFar)
        return ProbeLookup(directionWS, perceptualRoughness, 0.0);
    vec3 fromCapture = positionWS + surfaceToHit * directionWS - probe.capturePositionWS;
    float captureToHit = length(fromCapture);
    vec3 projected = normalizeOr(fromCapture, directionWS);
    // A wide lobe sees more than one point: blend towards the unprojected direction. Empirical, HDRP.
    float alpha2 = square(square(perceptualRoughness));
    vec3 direction = normalizeOr(mix(projected, directionWS, smoothstep(0.0, 1.0, alpha2)), projected);
    float sharper = perceptualRoughness;
    if ((flags & kProbesDistanceRoughness) != 0u && captureToHit > 0.0) {
        // Lagarde and de Rousiers 2014, listing 23: the lobe's footprint on the wall, seen from the capture position.
        float scaled = min(surfaceToHit / captureToHit * perceptualRoughness, perceptualRoughness);
        sharper = mix(scaled, perceptualRoughness, perceptualRoughness);
    }
    return ProbeLookup(direction, sharper, 1.0 / max(captureToHit, 1e-6));
}

#endif
