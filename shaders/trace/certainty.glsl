// How likely an answer is right, and the weight that follows from it. An answer may be wrong where the picture does not
// show the place that the ray meets: in the slab behind a surface, between the pixels of a silhouette, behind an
// occluder. Weights are probabilities: the share of right answers of a kind is measured (trace/answer_shares.glsl).
// What is shown beside the answer tells what it costs if it is wrong. docs/techniques/certainty.md
#ifndef GLINT_TRACE_CERTAINTY_GLSL
#define GLINT_TRACE_CERTAINTY_GLSL

#include "hierarchy/environment_radiance.glsl"
#include "trace/answer_shares.glsl"
#include "trace/crease.glsl"

layout(set = 0, binding = 48) uniform samplerCube environment;

/// Two pixels whose mean radiance differs by less than this factor show the same, for this purpose.
const float kContrast = 2.0;
/// A hit of a ray that came from beside lies farther than this behind the plane, in pixels there.
const float kSunk = 0.1;
/// The picture holds no reflections yet: what such a surface looks like is not known.
const float kMirrorF0 = 0.5;
/// Below, rays through the scene take the answer's place.
const float kCertain = 0.95;

struct Certainty {
    uint kind;   // kAnswer*
    float right; // share of answers of this kind that are right
    vec3 beside; // radiance of what the ray may have met instead
    bool known;  // something beside tells
    float reach; // so many pixels the true answer may lie beside this one
};

/// 0 below `bounds.x`, to 3 from `bounds.z` on.
uint binOf(float value, vec3 bounds) {
    return uint(dot(vec3(greaterThanEqual(vec3(value), bounds)), vec3(1.0)) + 0.5);
}

/// Radiance that the picture shows at `px`, and whether that is all there is to see of it.
vec3 radianceBeside(ivec2 px, out bool known) {
    Surface there = unpackSurface(texelFetch(metSurface, px, 0).xy);
    known = there.reflectivity < kMirrorF0;
    return shownRadiance(px, there.perceptualRoughness);
}

/// The darkest of what lies beside `px` in eight places.
void lookAround(ivec2 px, vec3 here, inout Certainty found) {
    float least = meanComponent(here) / kContrast;
    for (int i = 0; i < 8; ++i) {
        int reach = (i & 4) != 0 ? 8 : 2;
        ivec2 offset = (i & 1) != 0 ? ivec2(reach, 0) : ivec2(0, reach);
        ivec2 at = (i & 2) != 0 ? px - offset : px + offset;
        if (!onScreen(vec2(at)))
            continue;
        bool known;
        vec3 there = radianceBeside(at, known);
        float mean = meanComponent(there);
        if (!known || mean >= least)
            continue;
        least = mean;
        found.beside = there;
        found.known = true;
    }
}

/// A hit whose place lies between pixels of two surfaces: each may cover it, the more likely the nearer its pixel is.
void findEdge(Ray r, inout March end, vec3 here, inout Certainty found) {
    vec2 at = r.screen.startPX + r.screen.deltaPX * end.share;
    ivec2 px = floorToInt(end.hitPX);
    ivec2 corner = floorToInt(at - 0.5);
    float mean = meanComponent(here);
    float farthest = -1.0;
    ShownPlane hit;
    bool planeKnown = false;
    for (int i = 0; i < 4; ++i) {
        ivec2 other = corner + ivec2(i & 1, i >> 1);
        if (other == px || !onScreen(vec2(other)))
            continue;
        bool known;
        vec3 there = radianceBeside(other, known);
        float otherMean = meanComponent(there);
        if (!known || max(mean, otherMean) < kContrast * min(mean, otherMean))
            continue;
        if (!planeKnown)
            hit = planeOf(end.hitPX, besideHit(r, px, end), normalAt(end.hitPX));
        planeKnown = true;
        vec2 apart = vec2(other - px);
        float place = dot(at - hit.centerPX, apart) / dot(apart, apart);
        if (place <= farthest)
            continue;
        float otherZ = besideHit(r, other, end);
        float expected = nearnessAt(hit, vec2(other) + 0.5);
        float nearer = (otherZ >= kBackgroundZ ? 0.0 : nearnessOf(frame.constants, otherZ)) - expected;
        if (abs(nearer) <= kAtSurface * abs(expected))
            continue; // one surface, or two that meet
        farthest = place;
        found.kind = (nearer < 0.0 ? kAnswerBeforeEdge : kAnswerBehindEdge) + binOf(place, vec3(0.25, 0.5, 0.75));
        found.beside = there;
        found.known = true;
    }
}

/// How far behind what the picture shows at `px` the ray is, in pixels there.
float pixelsBehind(Ray r, float share, float sceneZ) {
    float pixel = pixelExtent(frame.constants, frame.constants.uvToView, sceneZ).y;
    return (rayViewZ(r.screen, share) - sceneZ) / pixel;
}

void judgeSide(Ray r, inout March end, inout Certainty found) {
    ivec2 px = floorToInt(end.hitPX);
    float sceneZ = besideHit(r, px, end);
    float pixel = pixelExtent(frame.constants, frame.constants.uvToView, sceneZ).y;
    float thick = (slabEnd(end.hitPX, sceneZ, end.lookups) - sceneZ) / pixel;
    uint byDepth = binOf(pixelsBehind(r, end.share, sceneZ), vec3(1.0, 4.0, 16.0));
    uint byThickness = min(binOf(thick, vec3(3.0, 16.0, 1e30)), 2u);
    found.kind = kAnswerSide + 3u * byDepth + byThickness;
    found.reach = thick;
}

/// `blurred`: the answer is a mean over more than a pixel, which edges between pixels do not change.
Certainty certaintyOf(Ray r, inout March end, vec3 radiance, bool blurred) {
    ivec2 px = floorToInt(end.hitPX);
    Certainty found = Certainty(kAnswerPlain, 1.0, radiance, false, 1.0);
    bool unused;
    vec3 here = radianceBeside(px, unused);
    if (end.outcome == kOutcomeHit) {
        found.kind = end.passedBehind ? kAnswerAfterHidden : kAnswerPlain;
        if (end.sunk) {
            float behind = pixelsBehind(r, end.share, besideHit(r, px, end));
            found.kind = kAnswerSunk + binOf(behind, vec3(1.0, 4.0, 16.0));
            lookAround(px, here, found);
        } else if (!blurred) {
            findEdge(r, end, here, found);
        }
    } else {
        lookAround(px, here, found);
        if (end.outcome == kOutcomeSide) {
            judgeSide(r, end, found);
        } else if (end.outcome == kOutcomeBackFace) {
            found.kind = kAnswerBackFace;
            found.reach = 1e9;
        } else {
            float apart = distance(end.hitPX, r.screen.startPX + r.screen.deltaPX * end.share);
            found.reach = apart;
            found.kind = end.evidence < 1.0 ? kAnswerOneSided : kAnswerInferred + binOf(apart, vec3(2.0, 8.0, 24.0));
        }
    }
    found.right = kRightShares[found.kind];
    return found;
}

/// What the next source answers, as far as it is known here.
vec3 nextAnswer(Ray r, vec3 beside, float perceptualRoughness) {
    if ((settings.flags & kTraceNextSky) == 0u)
        return beside;
    vec3 directionWS = mat3(frame.constants.viewToWorld) * r.directionVS;
    return environmentRadiance(environment, directionWS, perceptualRoughness);
}

/// The weight of the least expected error. The truth is `answer` with the probability `right`, else `beside`; the weight
/// that is left goes to `next`. Errors count as a display shows them: below its white as they are, above it relative to the
/// truth. So one lamp that is not there costs more than many dark places that are missed, but what is merely brighter than
/// the rest is not lost.
float leastError(float right, vec3 answer, vec3 beside, vec3 next) {
    const float kDisplayWhite = 1.0; // squared radiance
    vec3 ifRight = right / (answer * answer + kDisplayWhite);
    vec3 ifWrong = (1.0 - right) / (beside * beside + kDisplayWhite);
    vec3 gain = answer - next;
    float most = dot(gain * gain, ifRight + ifWrong);
    float wanted = dot(gain, gain * ifRight + (beside - next) * ifWrong);
    return most > 0.0 ? clamp(wanted / most, 0.0, 1.0) : right;
}

/// 1 where nothing tells what the ray may have met instead, and where no source answers for the weight that is left: an
/// uncertain answer is better than none. Behind a front the picture does not show what the ray met: it is no brighter
/// than what the next source answers, as far as is known.
float certainWeight(Ray r, Certainty certainty, vec3 radiance, float perceptualRoughness) {
    bool isBehind = certainty.kind >= kAnswerSide && certainty.kind < kAnswerInferred;
    bool nextTells = isBehind && (settings.flags & kTraceNextSky) != 0u;
    bool anyNext = (settings.flags & (kTraceNextSky | kTraceNextOther)) != 0u;
    if (!anyNext || !(certainty.known || nextTells))
        return 1.0;
    const vec3 kBrightest = vec3(2.0); // a display shows no more than its white; what glows counts a little more
    vec3 next = min(nextAnswer(r, certainty.beside, perceptualRoughness), kBrightest);
    vec3 beside = min(certainty.beside, nextTells ? next : kBrightest);
    return leastError(certainty.right, min(radiance, kBrightest), beside, next);
}

#endif
