// Radiance of the probes around a place in a direction, smallest volume first; each probe gets at most the remaining
// weight.
#ifndef GLINT_PROBES_PROBE_CUBES_GLSL
#define GLINT_PROBES_PROBE_CUBES_GLSL

#include "lib/sanitize.glsl"
#include "probes/probe_march.glsl"

/// Metres, infinite for a miss; negative: this probe has no answer.
float distanceToHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float perceptualRoughness, uint flags) {
    if ((flags & kProbesParallax) == 0u)
        return 1e30;
    uint steps = probe.distances != 0u ? flags >> kProbesStepsShift : 0u;
    float marched = kProbeUnseen;
    if (steps > 0u)
        marched = marchedDistance(probe, positionWS, directionWS, probeSearch(steps, perceptualRoughness));
    if (marched != kProbeUnseen)
        return marched;
    return probe.proxyShape == kProbeNoProxy ? 1e30 : proxyDistance(probe, positionWS, directionWS);
}

vec3 probeRadiance(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float surfaceToHit, float perceptualRoughness,
                   uint flags) {
    ProbeLookup lookup = probeLookup(probe, positionWS, directionWS, surfaceToHit, perceptualRoughness, flags);
    float mip = lookup.perceptualRoughness * probe.lastMip;
    vec3 radiance = textureLod(cubes[nonuniformEXT(probe.cube)], lookup.directionWS, mip).rgb;
    return sanitize(sanitize(radiance) * probe.strength);
}

/// Asks the probes around `weighedWS`. `ofObject`: `weighedWS` is an object's centre, which has no normal and faces
/// everywhere.
vec4 askProbes(vec3 weighedWS, bool ofObject, vec3 positionWS, vec3 normalWS, vec3 directionWS,
               float perceptualRoughness, float left, uint flags) {
    uvec2 range = probesAround(weighedWS);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (uint i = range.x; i < range.y && total < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float weight = ofObject ? probeWeightOfObject(probe, weighedWS)
                                : probeWeight(probe, weighedWS, normalWS, directionWS);
        weight = min(weight, left - total);
        if (weight <= 0.0)
            continue;
        float distance = distanceToHit(probe, positionWS, directionWS, perceptualRoughness, flags);
        if (distance < 0.0)
            continue;
        sum += weight * probeRadiance(probe, positionWS, directionWS, distance, perceptualRoughness, flags);
        total += weight;
    }
    return total > 0.0 ? vec4(sanitize(sum / total), total) : vec4(0.0);
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
