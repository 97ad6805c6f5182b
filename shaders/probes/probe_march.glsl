// What a ray meets in a probe's picture: the cube's alpha is 1 / metres to what it shows, so the ray is followed until it
// passes from before that to behind it. Szirmay-Kalos et al. 2005, "Approximate Ray-Tracing on the GPU with Distance
// Impostors", with a search in place of their fixed point, which may end behind what hides.
#ifndef GLINT_PROBES_PROBE_MARCH_GLSL
#define GLINT_PROBES_PROBE_MARCH_GLSL

#include "probes/probe_lists.glsl"

layout(set = 1, binding = 0) uniform samplerCube cubes[];

const uint kProbeHalvings = 6u;    // of a mirror's steps
const uint kProbeFewestSteps = 4u; // of the widest lobes
const float kProbeBias = 0.01;     // of the distance: what is nearer behind a surface may be the surface itself
const float kProbeEdge = 0.1;      // a larger step, as a share of 1 / distance, parts two surfaces
const float kProbeFarShown = 0.02; // in distances of the surface: as good as the sky, 50 times as far

/// A ray from what lies at `from`, seen from the capture position. Its points are those at (1 - u) from + u * along,
/// seen from there, with u from 0 at the start to 1 infinitely far away.
struct ProbeRay {
    vec3 from;
    vec3 along; // as long as `from`
    uint cube;
};

/// 1 / metres.
float shownAt(ProbeRay ray, vec3 at) {
    return textureLod(cubes[nonuniformEXT(ray.cube)], at, 0.0).a;
}

/// The same without the surfaces half way that filtering makes between what is near and what is far.
float shownSharply(ProbeRay ray, vec3 at) {
    vec4 around = textureGather(cubes[nonuniformEXT(ray.cube)], at, 3);
    float far = min(min(around.x, around.y), min(around.z, around.w));
    float near = max(max(around.x, around.y), max(around.z, around.w));
    return near - far > kProbeEdge * near ? far : shownAt(ray, at);
}

/// By how much a point is behind what the cube shows in its direction, in 1 / metres: < 0 before it. And the latter.
vec2 behindShown(ProbeRay ray, float u, bool sharply) {
    vec3 at = mix(ray.from, ray.along, u);
    float shown = sharply ? shownSharply(ray, at) : shownAt(ray, at);
    return vec2((1.0 - kProbeBias) * shown - (1.0 - u) * inversesqrt(max(dot(at, at), 1e-20)), shown);
}

const float kProbeUnseen = -1.0; // the picture does not say
const float kProbeHidden = -2.0; // the ray goes into the sky or far away, behind something

/// How closely a ray is followed: the points of one turn by half a circle at most, and what lies within the lobe
/// around it is not told apart.
struct ProbeSearch {
    uint steps;
    uint halvings;
};

ProbeSearch probeSearch(uint mostSteps, float perceptualRoughness) {
    // Half of GGX's normals lean by less than alpha, which turns the mirrored direction twice as far; half of that is
    // followed, as the middle of a lobe shows most.
    float lobe = square(perceptualRoughness);
    uint steps = uint(clamp(kPi / max(lobe, 1e-3), float(min(kProbeFewestSteps, mostSteps)), float(mostSteps)));
    float turn = kPi / float(steps); // from one to the next; halved until it is half as wide as the lobe
    return ProbeSearch(steps, uint(clamp(ceil(log2(2.0 * turn / max(lobe, 1e-3))), 1.0, float(kProbeHalvings))));
}

/// Metres to what the ray meets, infinite for the sky; or one of the above.
float marchedDistance(ProbeRecord probe, vec3 positionWS, vec3 directionWS, ProbeSearch search) {
    vec3 from = positionWS - probe.capturePositionWS;
    float scale = max(length(from), 1e-6);
    ProbeRay ray = ProbeRay(from, scale * directionWS, probe.cube);
    bool before = false;
    float last = 0.0;
    float lastShown = 0.0;
    float hidden = kProbeUnseen; // the answer if the ray does not come out again
    for (uint i = 0u; i <= search.steps; ++i) { // at 0: does the picture show the surface itself
        float u = float(i) / float(search.steps);
        vec2 at = behindShown(ray, u, false);
        if (at.x > 0.0 && before) {
            float front = last;
            float back = u;
            for (uint h = 0u; h < search.halvings; ++h) {
                float middle = 0.5 * (front + back);
                vec2 there = behindShown(ray, middle, true);
                lastShown = there.x > 0.0 ? lastShown : there.y;
                front = there.x > 0.0 ? front : middle;
                back = there.x > 0.0 ? middle : back;
                at = there.x > 0.0 ? there : at;
            }
            if (at.y - lastShown < kProbeEdge * at.y)
                return back < 1.0 ? scale * back / (1.0 - back) : 1e30;
            // What is beside the silhouette goes on behind it.
            hidden = lastShown * scale < kProbeFarShown ? kProbeHidden : scale * front / (1.0 - front);
        }
        before = at.x <= 0.0;
        last = u;
        lastShown = at.y;
    }
    return before ? 1e30 : hidden;
}

#endif
