// Radiance of the probes around a place in a direction, smallest volume first; each probe gets at most the remaining
// weight.
#ifndef GLINT_PROBES_PROBE_CUBES_GLSL
#define GLINT_PROBES_PROBE_CUBES_GLSL

#include "lib/sanitize.glsl"
#include "probes/probe_march.glsl"

const float kProxyFits = 0.5; // largest difference of 1 / distance, as a fraction of the larger one

// GGX's alpha from which proxies alone say what a lobe sees. The march follows its middle, and what that meets changes
// from pixel to pixel where a wide lobe's answer hardly does.
const float kWideLobe = 0.25;
const float kMirrorMip = 0.25; // finer lookups are those of mirrors

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

/// Of the march in the probe's cube; 0: a ray ends at the proxy, or infinitely far away.
uint marchSteps(ProbeRecord probe, uint flags) {
    return probe.distances != 0u && (flags & kProbesParallax) != 0u ? flags >> kProbesStepsShift : 0u;
}

/// Where the ray leaves the proxy; infinitely far away without one.
ProbeHit proxyHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, uint flags) {
    bool infinite = (flags & kProbesParallax) == 0u || probe.proxyShape == kProbeNoProxy;
    return ProbeHit(infinite ? 1e30 : proxyDistance(probe, positionWS, directionWS), true);
}

/// The march's answer; only for probes with distances.
ProbeHit probeHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, float perceptualRoughness, uint flags) {
    ProbeSearch search = probeSearch(marchSteps(probe, flags), perceptualRoughness);
    ProbeHit hit = marchedHit(probe, positionWS, directionWS, search);
    if (hit != kProbeUnseen)
        return hit;
    return proxyGuess(probe, positionWS, directionWS, proxyHit(probe, positionWS, directionWS, flags).distance);
}

/// What a mirror sees in a cube. Beside a silhouette filtering mixes two surfaces, and the mix with one that the ray has
/// passed would draw its outline onto what stands behind it. There only texels that show the met surface count. `shown`:
/// 1 / metres from the capture position to what was met; 0: the farthest surface there, or the sky.
vec3 mirroredRadiance(uint cube, vec3 at, float shown) {
    vec4 around = textureGather(cubes[nonuniformEXT(cube)], at, 3);
    vec2 nearFar = nearAndFar(around);
    if (nearFar.x - nearFar.y <= kProbeEdge * nearFar.x)
        return textureLod(cubes[nonuniformEXT(cube)], at, 0.0).rgb;
    vec4 off = abs(around - shown);
    vec4 met = vec4(lessThanEqual(off, vec4(nearAndFar(off).y + kProbeEdge * nearFar.x)));
    met /= dot(met, vec4(1.0));
    return vec3(dot(textureGather(cubes[nonuniformEXT(cube)], at, 0), met),
                dot(textureGather(cubes[nonuniformEXT(cube)], at, 1), met),
                dot(textureGather(cubes[nonuniformEXT(cube)], at, 2), met));
}

vec3 probeRadiance(ProbeRecord probe, vec3 positionWS, vec3 directionWS, ProbeHit hit, float perceptualRoughness,
                   uint flags) {
    ProbeLookup lookup = probeLookup(probe, positionWS, directionWS, hit.distance, perceptualRoughness, flags);
    float mip = lookup.perceptualRoughness * probe.lastMip;
    vec3 radiance = mip < kMirrorMip && marchSteps(probe, flags) != 0u
                        ? mirroredRadiance(probe.cube, lookup.directionWS, hit.certain ? lookup.shown : 0.0)
                        : textureLod(cubes[nonuniformEXT(probe.cube)], lookup.directionWS, mip).rgb;
    return sanitize(sanitize(radiance) * probe.strength);
}

/// Asks the probes around `weighedWS`; guesses get the weight that certain answers leave. `ofObject`: `weighedWS` is an
/// object's centre, which has no normal and faces everywhere.
vec4 askProbes(vec3 weighedWS, bool ofObject, vec3 positionWS, vec3 normalWS, vec3 directionWS,
               float perceptualRoughness, float left, uint flags) {
    uvec2 range = probesAround(weighedWS);
    vec4 certain = vec4(0.0); // weighted radiance, weight
    vec4 guessed = vec4(0.0);
    float wide = smoothstep(0.0, kWideLobe, square(perceptualRoughness));
    for (uint i = range.x; i < range.y && certain.a < left; ++i) {
        ProbeRecord probe = probes.list[probeLists.probe[i]];
        float weight = ofObject ? probeWeightOfObject(probe, weighedWS)
                                : probeWeight(probe, weighedWS, normalWS, directionWS);
        if (weight <= 0.0)
            continue;
        float byProxy = marchSteps(probe, flags) == 0u ? 1.0 : wide;
        float proxyWeight = min(weight * byProxy, left - certain.a);
        if (proxyWeight > 0.0) {
            ProbeHit hit = proxyHit(probe, positionWS, directionWS, flags);
            certain += proxyWeight *
                       vec4(probeRadiance(probe, positionWS, directionWS, hit, perceptualRoughness, flags), 1.0);
        }
        if (byProxy >= 1.0)
            continue;
        ProbeHit hit = probeHit(probe, positionWS, directionWS, perceptualRoughness, flags);
        weight = min(weight * (1.0 - byProxy), left - (hit.certain ? certain.a : guessed.a));
        if (hit.distance < 0.0 || weight <= 0.0)
            continue;
        vec4 answer = vec4(probeRadiance(probe, positionWS, directionWS, hit, perceptualRoughness, flags), 1.0);
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
