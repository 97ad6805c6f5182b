// What a ray crossed unseen. A ray without an answer that passed behind an occluder may have crossed a surface there:
// one that the frame shows beside the occluder, whose plane the ray was in front of before the occluder and is behind
// after it. Such a ray is answered with the nearest pixel that shows the surface (outcome `inferred`). It is a guess:
// the surface may have a hole or an end behind the occluder, and its colour may change there.
#ifndef GLINT_TRACE_INFER_GLSL
#define GLINT_TRACE_INFER_GLSL

#include "trace/crease.glsl"

/// Depth samples on the ray's line from where it went behind something to its end: more find small surfaces, and cost
/// as much as a march. Nearer than this many pixels they tell the same.
const uint kInferSamples = 6u;
const float kInferSpacing = 4.0;
/// How far beside the crossing the surface is looked for, as a fraction of the frame's height.
const float kInferReach = 0.25;
/// Planes whose crossing is looked for beside the occluder, at most.
const uint kInferPlanes = 2u;
/// The search for the occluder's edge ends this near to it, as a fraction of the distance from the crossing.
const float kInferEdge = 0.125;
/// Evidence of a surface that shows on one side only: all of it if the surface shows nearer to the crossing than
/// kInferSure of the frame's height, none from kInferUnsure on. tuned: hall, 640x360; with 0.12 the lit end wall shows
/// where the reflected one is dark, with 0.07 the fade is a step.
const float kInferSure = 0.01;
const float kInferUnsure = 0.08;
const float kInferSurePixels = 9.0; // kInferSure is at least this, however small the frame
/// So near, in pixels, the colour beside the crossing serves for it.
const float kInferNear = 8.0;
/// How far off a plane what a pixel shows may lie to belong to it, as a fraction of its nearness.
const float kInferSlack = 0.01;

/// What the surface beside an inferred crossing tells about it, 0 to 1: a factor of the answer's weight.
float inferredEvidence = 1.0;

const uint kOccluder = 0u; // the pixel shows something in front of the plane, or a surface that meets it there
const uint kSurface = 1u;  // the plane's surface
const uint kBeyond = 2u;   // something behind the plane: the plane's surface is not there
const uint kOffScreen = 3u;

uint compare(ShownPlane plane, vec2 px, float sceneZ) {
    if (sceneZ >= kBackgroundZ)
        return kBeyond;
    float expected = plane.nearness + dot(plane.slope, floor(px) + 0.5 - plane.centerPX);
    float nearer = nearnessOf(frame.constants, sceneZ) - expected;
    float slack = kInferSlack * abs(expected);
    if (nearer > slack)
        return kOccluder;
    if (nearer < -slack)
        return kBeyond;
    return dot(normalAt(px), plane.normalVS) > kOwnNormal ? kSurface : kOccluder;
}

uint lookBeside(Ray r, ShownPlane plane, Sample crossing, vec2 px, inout uint lookups) {
    if (!onScreen(px))
        return kOffScreen;
    float sceneZ = texelFetch(metViewZ, floorToInt(px), 0).r;
    ++lookups;
    logBeside(r.screen, crossing.share, px, crossing.rayZ, sceneZ);
    return compare(plane, px, sceneZ);
}

/// What lies beside the occluder in one direction.
struct Beside {
    uint shown;     // kSurface, kBeyond; else the search did not leave the occluder
    float distance; // pixels from the crossing
    vec2 px;
};

/// Leaves the occluder with growing steps up to `reach` pixels, then returns to its edge in at most four. `known`: what
/// a sample shows in this direction; kOccluder: nothing is known.
Beside besideOccluder(Ray r, ShownPlane plane, Sample crossing, vec2 direction, Beside known, float reach,
                      inout uint lookups) {
    Beside found = Beside(kOccluder, 0.0, crossing.px);
    bool knows = known.shown != kOccluder && known.distance <= reach;
    float inside = 0.0;
    float next = 3.0;
    int returns = 0;
    while (next <= reach && returns <= 4) {
        bool isKnown = knows && next >= known.distance;
        uint shown = isKnown ? known.shown : lookBeside(r, plane, crossing, crossing.px + direction * next, lookups);
        if (shown == kOccluder) {
            inside = next;
        } else {
            found.shown = shown;
            found.distance = next;
        }
        if (shown == kOffScreen)
            break;
        if (found.shown == kOccluder) { // has not left yet
            found.distance = next;
            float farthest = knows ? known.distance : reach;
            // A last step of less than half its size would tell little more, unless it is known.
            bool shortens = next < farthest && (knows || 2.0 * next <= farthest);
            next = shortens ? min(4.0 * next, farthest) : 4.0 * next;
            continue;
        }
        if (found.distance - inside <= max(kInferEdge * found.distance, 1.0))
            break;
        next = floor(0.5 * (inside + found.distance));
        ++returns;
    }
    bool isKnown = knows && found.distance >= known.distance; // the sum below may round to its neighbour
    found.px = isKnown ? known.px : crossing.px + direction * found.distance;
    return found;
}

/// Bit i: the surface shows in direction i of findSurface. Directions 0 and 1 are opposite, and so are 2 and 3.
bool onOpposite(uint shows) {
    return (shows & 3u) == 3u || (shows & 12u) == 12u;
}

const float kNowhere = 2.0; // as a share

/// Samples of the ray's line: the one before it went behind something, and those from there on.
struct HiddenLine {
    Sample samples[kInferSamples + 1u];
    uint count;
};

/// The nearest pixel beside the occluder that shows the plane's surface, and how much it tells about the crossing, 0 to
/// 1: all if the surface shows on two opposite sides. On one side only it must show nearer than anything behind the
/// plane, and tells the less the farther it is.
float findSurface(Ray r, ShownPlane plane, Sample crossing, HiddenLine line, inout uint lookups, out vec2 px) {
    vec2 along = normalize(r.screen.deltaPX);
    vec2 directions[4] = vec2[](along, -along, vec2(along.y, -along.x), vec2(-along.y, along.x));
    float height = frame.constants.size.y;
    float reach = kInferReach * height;
    float sure = max(kInferSure * height, kInferSurePixels);
    float unsure = max(kInferUnsure * height, 2.5 * sure);
    Beside unknown = Beside(kOccluder, reach, crossing.px);
    Beside known[4] =
        Beside[](unknown, unknown, unknown, unknown); // from the samples, after the crossing and before it
    for (uint i = 0u; i < line.count; ++i) {
        Sample s = line.samples[i];
        int side = s.share > crossing.share ? 0 : 1;
        float apart = distance(s.px, crossing.px);
        if (apart < 1.0 || apart >= known[side].distance)
            continue;
        uint shown = compare(plane, s.px, s.sceneZ);
        if (shown != kOccluder)
            known[side] = Beside(shown, apart, s.px);
    }
    const float kNone = 1e9;
    float nearestSurface = kNone;
    float nearestBeyond = kNone;
    uint shows = 0u; // a bit for each direction
    px = crossing.px;
    for (int i = 0; i < 4; ++i) {
        if (nearestSurface <= kInferNear && onOpposite(shows))
            break; // across the line it could hardly be nearer
        // Where the opposite direction does not show the surface, one side must tell.
        bool isAlone = (i & 1) == 1 && (shows & (1u << (i - 1))) == 0u;
        Beside found = besideOccluder(r, plane, crossing, directions[i], known[i], isAlone ? unsure : reach, lookups);
        if (found.shown == kBeyond)
            nearestBeyond = min(nearestBeyond, found.distance);
        if (found.shown != kSurface)
            continue;
        shows |= 1u << i;
        if (found.distance < nearestSurface) {
            nearestSurface = found.distance;
            px = found.px;
        }
    }
    if (onOpposite(shows))
        return 1.0;
    if (nearestSurface >= min(nearestBeyond, kNone))
        return 0.0;
    return 1.0 - smoothstep(sure, unsure, nearestSurface);
}

/// Where the ray crosses the plane of what the sample shows, from its front, between two places; kNowhere: it does not.
float crossingOf(Ray r, Sample s, float first, float last) {
    if (s.sceneZ >= kBackgroundZ)
        return kNowhere;
    ShownPlane plane = planeShown(s.px, s.sceneZ);
    float heightFirst = heightAt(r, plane, first);
    float heightLast = heightAt(r, plane, last);
    bool crosses = heightFirst > 0.0 && heightLast < 0.0 && facesRay(plane.normalVS, false, r) &&
                   !isOwnSurface(plane.pointVS, plane.normalVS, r);
    return crosses ? crossingShare(r.screen, first, heightFirst, last, heightLast) : kNowhere;
}

/// Answers a ray that ended without an answer after it went behind something, if it crossed a surface there: the first
/// one of those that its line shows. Takes samples up to the first one after a crossing, then tests that crossing.
void inferCrossing(Ray r, inout March end) {
    float pixelShare = 1.0 / screenPixels(r.screen);
    float last = min(end.share, r.screen.screenEnd);
    float first = max(firstBehind - pixelShare, 0.0);
    float spacing = max(kInferSpacing * pixelShare, (last - firstBehind) / float(kInferSamples));
    HiddenLine line;
    line.count = 0u;
    float crossings[kInferSamples + 1u];
    float next = first;
    for (uint tries = 0u; tries < kInferPlanes;) {
        uint which = 0u;
        float share = kNowhere;
        for (uint i = 0u; i < line.count; ++i)
            if (crossings[i] < share) {
                which = i;
                share = crossings[i];
            }
        bool ended = line.count > kInferSamples || next >= last;
        if (!ended && (line.count == 0u || line.samples[line.count - 1u].share <= share)) {
            line.samples[line.count] = takeSample(r.screen, next, end.lookups);
            crossings[line.count] = crossingOf(r, line.samples[line.count], first, last);
            next = firstBehind + float(line.count) * spacing;
            ++line.count;
            continue;
        }
        if (share >= kNowhere)
            return;
        for (uint i = 0u; i < line.count; ++i) // the same plane
            crossings[i] = crossings[i] <= share + pixelShare ? kNowhere : crossings[i];
        vec2 crossingPX = r.screen.startPX + r.screen.deltaPX * share;
        if (distance(line.samples[which].px, crossingPX) > kInferReach * frame.constants.size.y)
            continue; // no search would find it
        ShownPlane plane = planeShown(line.samples[which].px, line.samples[which].sceneZ);
        Sample crossing = takeSample(r.screen, share, end.lookups);
        uint there = compare(plane, crossing.px, crossing.sceneZ);
        if (there == kBeyond)
            continue; // the surface would show
        if (endsAsRim(floorToInt(line.samples[which].px), plane.normalVS, plane.pointVS, crossing.rayZ, end.lookups))
            continue; // its plane goes on there, the surface does not
        vec2 px = crossing.px;
        float evidence = 1.0;
        if (there == kOccluder) {
            evidence = findSurface(r, plane, crossing, line, end.lookups, px);
            ++tries;
        }
        if (evidence <= 0.0)
            continue;
        logDecision(crossing.px, kSampleInferred);
        end.outcome = kOutcomeInferred;
        end.hitPX = clamp(px, floor(px) + 0.01, floor(px) + 0.99); // the same pixel once stored
        end.share = crossing.share;
        inferredEvidence = evidence;
        return;
    }
}

#endif
