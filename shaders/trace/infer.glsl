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
    float sceneZ = loadSceneZ(floorToInt(px));
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

/// A search for it: leaves the occluder with growing steps up to `reach` pixels, then returns to its edge in at most
/// four.
struct Search {
    vec2 direction;
    float reach;
    Beside known;   // what a sample shows in this direction; kOccluder: nothing is known
    uint shown;     // so far,
    float distance; // and where
    float inside;   // so far from the crossing it is still the occluder
    float next;     // here it looks next
    int returns;
    bool ended;
};

Search startSearch(vec2 direction, float reach, Beside known) {
    const float kFirst = 3.0;
    Search search;
    search.direction = direction;
    search.reach = reach;
    search.known = known;
    search.known.shown = known.distance <= reach ? known.shown : kOccluder;
    search.shown = kOccluder;
    search.distance = 0.0;
    search.inside = 0.0;
    search.next = kFirst;
    search.returns = 0;
    search.ended = kFirst > reach;
    return search;
}

/// A step of a search that has not ended.
void lookOnce(Ray r, ShownPlane plane, Sample crossing, inout Search search, inout uint lookups) {
    bool knows = search.known.shown != kOccluder;
    uint shown = search.known.shown;
    if (!knows || search.next < search.known.distance)
        shown = lookBeside(r, plane, crossing, crossing.px + search.direction * search.next, lookups);
    if (shown == kOccluder) {
        search.inside = search.next;
    } else {
        search.shown = shown;
        search.distance = search.next;
    }
    if (search.shown == kOccluder) { // has not left yet
        search.distance = search.next;
        float farthest = knows ? search.known.distance : search.reach;
        // A last step of less than half its size would tell little more, unless it is known.
        bool shortens = search.next < farthest && (knows || 2.0 * search.next <= farthest);
        search.next = shortens ? min(4.0 * search.next, farthest) : 4.0 * search.next;
    } else {
        search.ended = shown == kOffScreen ||
                       search.distance - search.inside <= max(kInferEdge * search.distance, 1.0);
        search.next = floor(0.5 * (search.inside + search.distance));
        ++search.returns;
    }
    search.ended = search.ended || search.next > search.reach || search.returns > 4;
}

Beside resultOf(Search search, Sample crossing) {
    // The sum may round to the neighbour of a known place.
    bool isKnown = search.known.shown != kOccluder && search.distance >= search.known.distance;
    vec2 px = isKnown ? search.known.px : crossing.px + search.direction * search.distance;
    return Beside(search.shown, search.distance, px);
}

/// Bit i: the surface shows in direction i of findSurface. Directions 0 and 1 are opposite, and so are 2 and 3.
bool onOpposite(uint shows) {
    return (shows & 3u) == 3u || (shows & 12u) == 12u;
}

const float kNowhere = 2.0; // as a share
/// With the sample before the ray went behind something.
const uint kHiddenSamples = kInferSamples + 1u;

/// Samples of the ray's line: the one before it went behind something, and those from there on. Arrays are indexed
/// by constants, and by pick and put, which leaves them in registers.
struct HiddenLine {
    float first;  // share of the sample before,
    float behind; // and of the one after
    float spacing;
    uint count;
    float sceneZ[kHiddenSamples];
    float crossings[kHiddenSamples]; // shares; kNowhere: none, or looked at
};

float pick(float values[kHiddenSamples], uint which) {
    float picked = values[0];
    for (uint i = 1u; i < kHiddenSamples; ++i)
        picked = i == which ? values[i] : picked;
    return picked;
}

void put(inout float values[kHiddenSamples], uint which, float value) {
    for (uint i = 0u; i < kHiddenSamples; ++i)
        values[i] = i == which ? value : values[i];
}

/// Where the line's sample `which` is, as a share.
float shareOf(HiddenLine line, uint which) {
    return which == 0u ? line.first : line.behind + float(which - 1u) * line.spacing;
}

/// The place of a sample there, as takeSample has it.
vec2 placeOfSample(ScreenRay ray, float share) {
    return placeInPixel(ray, floorToInt(ray.startPX + ray.deltaPX * share), share);
}

/// The nearest pixel beside the occluder that shows the plane's surface, and how much it tells about the crossing, 0 to
/// 1: all if the surface shows on two opposite sides. On one side only it must show nearer than anything behind the
/// plane, and tells the less the farther it is.
float findSurface(Ray r, ShownPlane plane, Sample crossing, HiddenLine line, inout uint lookups, out vec2 px) {
    vec2 along = normalize(r.screen.deltaPX);
    float height = frame.constants.size.y;
    float reach = kInferReach * height;
    float sure = max(kInferSure * height, kInferSurePixels);
    float unsure = max(kInferUnsure * height, 2.5 * sure);
    Beside unknown = Beside(kOccluder, reach, crossing.px);
    Beside knownAfter = unknown; // the crossing, from the samples
    Beside knownBefore = unknown;
    for (uint i = 0u; i < line.count; ++i) {
        float share = shareOf(line, i);
        bool after = share > crossing.share;
        vec2 at = placeOfSample(r.screen, share);
        float apart = distance(at, crossing.px);
        if (apart < 1.0 || apart >= (after ? knownAfter : knownBefore).distance)
            continue;
        uint shown = compare(plane, at, pick(line.sceneZ, i));
        if (shown == kOccluder)
            continue;
        if (after)
            knownAfter = Beside(shown, apart, at);
        else
            knownBefore = Beside(shown, apart, at);
    }
    const float kNone = 1e9;
    float nearestSurface = kNone;
    float nearestBeyond = kNone;
    uint shows = 0u; // a bit for each direction
    px = crossing.px;
    Search search = startSearch(along, reach, knownAfter);
    // One loop over all steps: the rays of a group need not wait for each other at the end of each direction.
    for (int i = 0; true;) {
        if (!search.ended) {
            lookOnce(r, plane, crossing, search, lookups);
            continue;
        }
        Beside found = resultOf(search, crossing);
        if (found.shown == kBeyond)
            nearestBeyond = min(nearestBeyond, found.distance);
        if (found.shown == kSurface) {
            shows |= 1u << i;
            px = found.distance < nearestSurface ? found.px : px;
            nearestSurface = min(nearestSurface, found.distance);
        }
        ++i;
        if (i == 4 || (nearestSurface <= kInferNear && onOpposite(shows)))
            break; // across the line it could hardly be nearer
        // Where the opposite direction does not show the surface, one side must tell.
        bool isAlone = (i & 1) == 1 && (shows & (1u << (i - 1))) == 0u;
        vec2 direction = (i & 2) == 0 ? along : vec2(along.y, -along.x);
        direction = (i & 1) == 0 ? direction : -direction;
        search = startSearch(direction, isAlone ? unsure : reach, i == 1 ? knownBefore : unknown);
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
    float first = max(end.firstBehind - pixelShare, 0.0);
    float spacing = max(kInferSpacing * pixelShare, (last - end.firstBehind) / float(kInferSamples));
    HiddenLine line;
    line.first = first;
    line.behind = end.firstBehind;
    line.spacing = spacing;
    line.count = 0u;
    for (uint i = 0u; i < kHiddenSamples; ++i) {
        line.sceneZ[i] = 0.0;
        line.crossings[i] = kNowhere;
    }
    for (uint tries = 0u; tries < kInferPlanes;) {
        float share = kNowhere;
        for (uint i = 0u; i < kHiddenSamples; ++i)
            share = min(share, line.crossings[i]);
        // A loop of its own: the rays of a group look for crossings together, then test them.
        while (line.count < kHiddenSamples) {
            float next = shareOf(line, line.count);
            if (next >= last || (line.count > 0u && shareOf(line, line.count - 1u) > share))
                break;
            Sample s = takeSample(r.screen, next, end.lookups);
            float crossing = crossingOf(r, s, first, last);
            put(line.sceneZ, line.count, s.sceneZ);
            put(line.crossings, line.count, crossing);
            share = min(share, crossing);
            ++line.count;
        }
        if (share >= kNowhere)
            return;
        uint which = 0u;
        for (uint i = kHiddenSamples; i-- > 0u;)
            which = line.crossings[i] == share ? i : which;
        for (uint i = 0u; i < kHiddenSamples; ++i) // the same plane
            line.crossings[i] = line.crossings[i] <= share + pixelShare ? kNowhere : line.crossings[i];
        vec2 shownPX = placeOfSample(r.screen, shareOf(line, which));
        vec2 crossingPX = r.screen.startPX + r.screen.deltaPX * share;
        if (distance(shownPX, crossingPX) > kInferReach * frame.constants.size.y)
            continue; // no search would find it
        ShownPlane plane = planeShown(shownPX, pick(line.sceneZ, which));
        Sample crossing = takeSample(r.screen, share, end.lookups);
        uint there = compare(plane, crossing.px, crossing.sceneZ);
        if (there == kBeyond)
            continue; // the surface would show
        if (endsAsRim(floorToInt(shownPX), plane.normalVS, plane.pointVS, crossing.rayZ, end.lookups))
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
        end.evidence = evidence;
        return;
    }
}

#endif
