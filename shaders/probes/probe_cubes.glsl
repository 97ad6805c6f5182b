// What the probes around a place show in a direction, smallest volume first, each getting at most what is left.
#ifndef GLINT_PROBES_PROBE_CUBES_GLSL
#define GLINT_PROBES_PROBE_CUBES_GLSL

#include "lib/sanitize.glsl"
#include "probes/probe_march.glsl"

/// Metres, infinite where nothing is met; negative: not this probe's to say.
float distanceToHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, uint flags) {
    if ((flags & kProbesParallax) == 0u)
        return 1e30;
    uint steps = probe.distances != 0u ? flags >> kProbesStepsShift : 0u;
    float marched = steps > 0u ? marchedDistance(probe, positionWS, directionWS, steps) : kProbeUnseen;
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

/// Mean radiance and weight, at most `left`. `flags`: kProbes*.
vec4 probesAnswer(vec3 positionWS, vec3 normalWS, vec3 directionWS, float perceptualRoughness, float left, uint flags) {
    uvec2 range = probesAround(positionWS);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (uint i = range.x; i < range.y && total < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float weight = min(probeWeight(probe, positionWS, normalWS, directionWS), left - total);
        if (weight <= 0.0)
            continue;
        float surfaceToHit = distanceToHit(probe, positionWS, directionWS, flags);
        if (surfaceToHit < 0.0)
            continue;
        sum += weight * probeRadiance(probe, positionWS, directionWS, surfaceToHit, perceptualRoughness, flags);
        total += weight;
    }
    return total > 0.0 ? vec4(sanitize(sum / total), total) : vec4(0.0);
}

/// The same for light that leaves an object at `positionWS`: all of it asks the probes that hold the object's centre, so
/// that no seam of theirs runs across it.
vec4 probesAnswerOfObject(vec3 centerWS, vec3 positionWS, vec3 directionWS, float perceptualRoughness, float left,
                          uint flags) {
    uvec2 range = probesAround(centerWS);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (uint i = range.x; i < range.y && total < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float depth = influenceDepth(probe, intoVolume(probe.worldToInfluence, vec4(centerWS, 1.0)));
        float weight = min(smoothstep(0.0, 1.0, depth) * probe.weight, left - total);
        if (weight <= 0.0)
            continue;
        float exitToHit = distanceToHit(probe, positionWS, directionWS, flags);
        if (exitToHit < 0.0)
            continue;
        sum += weight * probeRadiance(probe, positionWS, directionWS, exitToHit, perceptualRoughness, flags);
        total += weight;
    }
    return total > 0.0 ? vec4(sanitize(sum / total), total) : vec4(0.0);
}

#endif
