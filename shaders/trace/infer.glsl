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
/// So near, in pixels, the colour beside the crossing serves for it.
const float kInferNear = 8.0;
/// How far off a plane what a pixel shows may lie to belong to it, as a fraction of its nearness.
const float kInferSlack = 0.01;

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

/// Leaves the occluder with growing steps, then returns to its edge in at most four.
Beside besideOccluder(Ray r, ShownPlane plane, Sample crossing, vec2 direction, inout uint lookups) {
    Beside found = Beside(kOccluder, 0.0, crossing.px);
    float reach = kInferReach * frame.constants.size.y;
    float inside = 0.0;
    float next = 1.0;
    int returns = 0;
    while (next <= reach && returns <= 4) {
        uint shown = lookBeside(r, plane, crossing, crossing.px + direction * next, lookups);
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
            next *= 4.0;
            continue;
        }
        if (found.distance - inside <= 1.0)
            break;
        next = floor(0.5 * (inside + found.distance));
        ++returns;
    }
    found.px = crossing.px + direction * found.distance;
    return found;
}

/// Bit i: the surface shows in direction i of findSurface. Directions 0 and 1 are opposite, and so are 2 and 3.
bool onOpposite(uint shows) {
    return (shows & 3u) == 3u || (shows & 12u) == 12u;
}

/// The nearest pixel beside the occluder that shows the plane's surface. It counts if the surface shows on two opposite
/// sides, or if nothing else shows nearer.
bool findSurface(Ray r, ShownPlane plane, Sample crossing, inout uint lookups, out vec2 px) {
    vec2 along = normalize(r.screen.deltaPX);
    vec2 directions[4] = vec2[](along, -along, vec2(along.y, -along.x), vec2(-along.y, along.x));
    const float kNone = 1e9;
    float nearestSurface = kNone;
    float nearestBeyond = kNone;
    uint shows = 0u; // a bit for each direction
    for (int i = 0; i < 4; ++i) {
        if (nearestSurface <= kInferNear && onOpposite(shows))
            break; // across the line it could hardly be nearer
        Beside found = besideOccluder(r, plane, crossing, directions[i], lookups);
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
    return onOpposite(shows) || nearestSurface < min(nearestBeyond, kNone);
}

/// Tests whether the ray crossed, between `front` and `behind`, the surface that the sample `shown` shows. Returns true
/// if the search is over; `end` changes if it did.
bool inferFrom(Ray r, Sample shown, float front, float behind, inout March end) {
    ShownPlane plane = planeShown(shown.px, shown.sceneZ);
    if (!facesRay(plane.normalVS, false, r) || isOwnSurface(plane.pointVS, plane.normalVS, r))
        return false;
    float heightFront = heightAt(r, plane, front);
    float heightBehind = heightAt(r, plane, behind);
    if (heightFront <= 0.0 || heightBehind >= 0.0)
        return false;
    Sample crossing =
        takeSample(r.screen, crossingShare(r.screen, front, heightFront, behind, heightBehind), end.lookups);
    uint there = compare(plane, crossing.px, crossing.sceneZ);
    if (there == kBeyond)
        return false; // the surface would show
    vec2 px = crossing.px;
    if (there == kOccluder && !findSurface(r, plane, crossing, end.lookups, px))
        return true;
    logDecision(crossing.px, kSampleInferred);
    end.outcome = kOutcomeInferred;
    end.hitPX = px;
    end.share = crossing.share;
    return true;
}

/// Answers a ray that ended without an answer after it went behind something, if it crossed a surface there.
void inferCrossing(Ray r, inout March end) {
    float pixelShare = 1.0 / screenPixels(r.screen);
    float last = min(end.share, r.screen.screenEnd);
    float spacing = max(kInferSpacing * pixelShare, (last - firstBehind) / float(kInferSamples));
    Sample front = takeSample(r.screen, max(firstBehind - pixelShare, 0.0), end.lookups);
    bool wasBehind = false;
    for (uint i = 0u; i < kInferSamples; ++i) {
        Sample s = takeSample(r.screen, firstBehind + float(i) * spacing, end.lookups);
        if (s.share >= last)
            return;
        bool behind = s.rayZ >= s.sceneZ;
        // Behind something: what shows there. Out of the occluder: the surfaces on both sides of it may meet behind it.
        uint sides = behind ? 1u : wasBehind ? 2u : 0u;
        for (uint side = 0u; side < sides; ++side) {
            Sample shown = s;
            if (!behind && side == 0u)
                shown = front;
            if ((behind || shown.sceneZ < kBackgroundZ) && inferFrom(r, shown, front.share, s.share, end))
                return;
        }
        wasBehind = behind;
        if (!behind)
            front = s;
    }
}

#endif
