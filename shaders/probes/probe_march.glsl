// Intersects a ray with a probe's cube. The cube's alpha is 1 / metres to the surface it shows, so the march continues
// until the ray passes from before that surface to behind it. Szirmay-Kalos et al. 2005, "Approximate Ray-Tracing on
// the GPU with Distance Impostors", with a search instead of their fixed point, which may end behind an occluder.
#ifndef GLINT_PROBES_PROBE_MARCH_GLSL
#define GLINT_PROBES_PROBE_MARCH_GLSL

#include "probes/probe_lists.glsl"

layout(set = 1, binding = 0) uniform samplerCube cubes[];

const uint kProbeHalvings = 6u;    // of a mirror's steps
const uint kProbeFewestSteps = 4u; // of the widest lobes
const float kProbeBias = 0.01;     // fraction of the distance: a hit nearer behind a surface may be the surface itself
const float kProbeEdge = 0.1;      // a larger step, as a fraction of 1 / distance, separates two surfaces
const float kProbeClear = 2.0;     // texels from a silhouette: clear of those that mix two surfaces
const float kProbeFarShown = 0.02; // in distances of the surface: treated as the sky, 50 times as far

/// A ray from the point `from`, relative to the capture position. Its points lie in the directions (1 - u) from + u *
/// along, with u from 0 at the start to 1 infinitely far away.
struct ProbeRay {
    vec3 from;
    vec3 along; // as long as `from`
    uint cube;
};

/// 1 / metres.
float shownAt(ProbeRay ray, vec3 at) {
    return textureLod(cubes[nonuniformEXT(ray.cube)], at, 0.0).a;
}

/// The largest and the smallest of four texels.
vec2 nearAndFar(vec4 around) {
    return vec2(max(max(around.x, around.y), max(around.z, around.w)),
                min(min(around.x, around.y), min(around.z, around.w)));
}

/// As shownAt, without the surfaces in between that filtering makes of a near and a far one.
float shownSharply(ProbeRay ray, vec3 at) {
    vec4 around = textureGather(cubes[nonuniformEXT(ray.cube)], at, 3);
    vec2 nearFar = nearAndFar(around);
    return nearFar.x - nearFar.y > kProbeEdge * nearFar.x ? nearFar.y : shownAt(ray, at);
}

/// How far a point is behind the surface that the cube shows in its direction, in 1 / metres: < 0 before it. And that
/// surface's value.
vec2 behindShown(ProbeRay ray, float u, bool sharply) {
    vec3 at = mix(ray.from, ray.along, u);
    float shown = sharply ? shownSharply(ray, at) : shownAt(ray, at);
    return vec2((1.0 - kProbeBias) * shown - (1.0 - u) * inversesqrt(max(dot(at, at), 1e-20)), shown);
}

/// What the cube knows of a ray.
struct ProbeHit {
    float distance; // metres, infinite for the sky; negative: no answer
    bool certain;   // false: the hit is hidden, and this is the surface beside what hides it, continued
};

const ProbeHit kProbeUnseen = ProbeHit(-1.0, false); // the cube does not show the ray's start
const ProbeHit kProbeNoHit = ProbeHit(-2.0, false);  // the ray goes into the sky or far away, behind a surface

/// Precision of the march: the points of one ray turn by half a circle at most, and details within the lobe around the
/// ray are not resolved.
struct ProbeSearch {
    uint steps;
    uint halvings;
};

ProbeSearch probeSearch(uint mostSteps, float perceptualRoughness) {
    // Half of GGX's normals deviate by less than alpha, which turns the mirrored direction twice as far. The march
    // resolves half of that angle, because the middle of a lobe has most of its weight.
    float lobe = square(perceptualRoughness);
    uint steps = uint(clamp(kPi / max(lobe, 1e-3), float(min(kProbeFewestSteps, mostSteps)), float(mostSteps)));
    float turn = kPi / float(steps); // between points; halved until it is half as wide as the lobe
    return ProbeSearch(steps, uint(clamp(ceil(log2(2.0 * turn / max(lobe, 1e-3))), 1.0, float(kProbeHalvings))));
}

/// Metres along the ray.
float distanceAt(float scale, float u) {
    return u < 1.0 ? scale * u / (1.0 - u) : 1e30;
}

/// A place on the ray at which the cube shows the surface beside the silhouette at `front`, clear of the texels that
/// mix both; at most as far back as `last`.
float besideSilhouette(ProbeRay ray, float front, float last) {
    float texel = 0.5 * kPi / float(textureSize(cubes[nonuniformEXT(ray.cube)], 0).x);
    vec3 there = normalizeOr(mix(ray.from, ray.along, front), vec3(0.0));
    vec3 before = normalizeOr(mix(ray.from, ray.along, last), vec3(0.0));
    return mix(front, last, min(kProbeClear * texel / max(distance(there, before), 1e-6), 1.0));
}

/// For two places in front of what the cube shows, of which only the first shows the nearer surface: a place between them
/// at which the ray is behind that surface, so that it has met it, and what the cube shows there; 0 if there is none. That
/// is most likely just before the surface ends, where the search goes.
vec2 behindItsEnd(ProbeRay ray, float near, float far, float shownFar, uint halvings) {
    vec2 start = behindShown(ray, near, true); // a mix of both surfaces is neither
    if (start.x > 0.0 || start.y - shownFar < kProbeEdge * start.y)
        return vec2(0.0);
    for (uint h = 0u; h < halvings; ++h) {
        float middle = 0.5 * (near + far);
        vec2 there = behindShown(ray, middle, true);
        if (there.x > 0.0)
            return vec2(middle, there.y);
        bool ended = there.y - shownFar < kProbeEdge * there.y;
        near = ended ? near : middle;
        far = ended ? middle : far;
    }
    return vec2(0.0);
}

ProbeHit marchedHit(ProbeRecord probe, vec3 positionWS, vec3 directionWS, ProbeSearch search) {
    vec3 from = positionWS - probe.capturePositionWS;
    float scale = max(length(from), 1e-6);
    ProbeRay ray = ProbeRay(from, scale * directionWS, probe.cube);
    bool before = false;
    float last = 0.0;
    float lastShown = 0.0;
    ProbeHit hidden = kProbeUnseen; // the answer if the ray does not come out again
    for (uint i = 0u; i <= search.steps; ++i) { // at 0: tests whether the cube shows the surface itself
        float u = float(i) / float(search.steps);
        vec2 at = behindShown(ray, u, false);
        vec2 met = vec2(u, at.y); // a place behind the surface that the ray meets, and what the cube shows there
        bool meets = before && at.x > 0.0;
        if (before && at.x <= 0.0 && lastShown - at.y > kProbeEdge * lastShown) {
            met = behindItsEnd(ray, last, u, at.y, search.halvings);
            meets = met.x > 0.0;
        }
        if (meets) {
            float front = last;
            for (uint h = 0u; h < search.halvings; ++h) {
                float middle = 0.5 * (front + met.x);
                vec2 there = behindShown(ray, middle, true);
                front = there.x > 0.0 ? front : middle;
                met = there.x > 0.0 ? vec2(middle, there.y) : met;
            }
            float beside = behindShown(ray, front, true).y;
            if (met.y - beside < kProbeEdge * met.y)
                return ProbeHit(distanceAt(scale, met.x), true);
            if (at.x > 0.0)
                hidden = beside * scale < kProbeFarShown
                             ? kProbeNoHit
                             : ProbeHit(distanceAt(scale, besideSilhouette(ray, front, last)), false);
        }
        before = at.x <= 0.0;
        last = u;
        lastShown = at.y;
    }
    return before ? ProbeHit(1e30, true) : hidden;
}

#endif
