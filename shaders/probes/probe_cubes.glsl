// Radiance of the probes around a place in a direction, smallest volume first; each probe gets at most the remaining
// weight.
#ifndef GLINT_PROBES_PROBE_CUBES_GLSL
#define GLINT_PROBES_PROBE_CUBES_GLSL

#include "lib/sanitize.glsl"
#include "probes/probe_march.glsl"

const float kProxyFits = 0.5; // largest difference of 1 / distance, as a fraction of the larger one

/// The proxy's answer where the cube does not show the ray's start: only where the cube shows a surface near the
/// proxy's. In the open the proxy of a street's houses is a wall as high as the sky. An infinite proxy always answers.
ProbeHit proxyGuess(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float toProxy) {
    if (toProxy > kProbeFar)
        return ProbeHit(toProxy, false);
    vec3 at = positionWS + toProxy * directionWS - probe.capturePositionWS;
    float expected = inversesqrt(max(dot(at, at), 1e-20));
    float shown = textureLod(cubes[nonuniformEXT(probe.cube)], at, 0.0).a;
    bool fits = abs(shown - expected) < kProxyFits * max(shown, expected);
    return fits ? ProbeHit(toProxy, false) : kProbeNoHit;
}

ProbeHit probeHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float perceptualRoughness, uint flags) {
    if ((flags & kProbesParallax) == 0u)
        return ProbeHit(1e30, true);
    uint steps = probe.distances != 0u ? flags >> kProbesStepsShift : 0u;
    float toProxy = probe.proxyShape == kProbeNoProxy ? 1e30 : proxyDistance(probe, positionWS, directionWS);
    if (steps == 0u)
        return ProbeHit(toProxy, true);
    ProbeHit hit = marchedHit(probe, positionWS, directionWS, probeSearch(steps, perceptualRoughness));
    return hit == kProbeUnseen ? proxyGuess(probe, positionWS, directionWS, toProxy) : hit;
}

vec3 probeRadiance(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float surfaceToHit, float perceptualRoughness,
                   uint flags) {
    ProbeLookup lookup = probeLookup(probe, positionWS, directionWS, surfaceToHit, perceptualRoughness, flags);
    float mip = lookup.perceptualRoughness * probe.lastMip;
    vec3 radiance = textureLod(cubes[nonuniformEXT(probe.cube)], lookup.directionWS, mip).rgb;
    return sanitize(sanitize(radiance) * probe.strength);
}

/// Asks the probes around `weighedWS`; guesses get the weight that certain answers leave. `ofObject`: `weighedWS` is an
/// object's centre, which has no normal and faces everywhere.
vec4 askProbes(vec3 weighedWS, bool ofObject, vec3 positionWS, vec3 normalWS, vec3 directionWS,
               float perceptualRoughness, float left, uint flags) {
    uvec2 range = probesAround(weighedWS);
    vec4 certain = vec4(0.0); // weighted radiance, weight
    vec4 guessed = vec4(0.0);
    for (uint i = range.x; i < range.y && certain.a < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float weight = ofObject ? probeWeightOfObject(probe, weighedWS)
                                : probeWeight(probe, weighedWS, normalWS, directionWS);
        if (weight <= 0.0)
            continue;
        ProbeHit hit = probeHit(probe, positionWS, directionWS, perceptualRoughness, flags);
        weight = min(weight, left - (hit.certain ? certain.a : guessed.a));
        if (hit.distance < 0.0 || weight <= 0.0)
            continue;
        vec4 answer = vec4(probeRadiance(probe, positionWS, directionWS, hit.distance, perceptualRoughness, flags), 1.0);
        certain += hit.certain ? weight * answer : vec4(0.0);
        guessed += hit.certain ? vec4(0.0) : weight * answer;
    }
    vec4 sum = certain + guessed * min((left - certain.a) / max(guessed.a, 1e-6), 1.0);
    return sum.a > 0.0 ? vec4(sanitize(sum.rgb / sum.a), sum.a) : vec4(0.0);
}

/// Mean radiance and weight, at most `left`. `flags`: kProbes*.
vec4 probesAnswer(vec3 positionWS, vec3 normalWS, vec3 directionWS, float perceptualRoughness, float left, uint flags) {
    return askProbes(positionWS, false, positionWS, normalWS, directionWS, perceptualRoughness, left, flags);
}

/// As probesAnswer, for light that leaves an object at `positionWS`: all of that light asks the probes that hold the
/// object's centre, so that no seam between probes runs across the object.
vec4 probesAnswerOfObject(vec3 centerWS, vec3 positionWS, vec3 directionWS, float perceptualRoughness, float left,
                          uint flags) {
    return askProbes(centerWS, true, positionWS, vec3(0.0), directionWS, perceptualRoughness, left, flags);
}

#endif
