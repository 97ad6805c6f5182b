// When a ray meets what the picture shows. A pixel knows its surface's depth and normal, so it is held for a small flat
// piece: the ray meets its front if it goes from before the piece's plane to behind it, whatever the piece's thickness.
// A ray that comes upon it from elsewhere, behind its plane already, runs into its side if it is no deeper than the
// slab: the thing is solid there, but the picture does not show where the ray meets it.
#ifndef GLINT_TRACE_HIT_TEST_GLSL
#define GLINT_TRACE_HIT_TEST_GLSL

#include "lib/math.glsl"
#include "lib/nearness.glsl"
#include "trace/ray.glsl"

/// dot(normal at the hit, -ray) below which a surface was met from behind. A little below 0, as shading normals lean;
/// `fade.backface` fades what lies between.
const float kBackFaceLimit = -0.17;
/// Both points may lie on one surface, which its own ray never meets from the front, if their normals differ by no more
/// than 25 degrees (cosine) and the start lies no farther off the other point's plane than this share of their
/// distance.
const float kOwnNormal = 0.9;
const float kOwnPlane = 0.15;

/// How exactly depth places a surface, in parts of its distance.
const float kDepthRounding = 1e-5;

/// So close behind the front, in parts of its distance, a ray from beside meets what the picture shows.
const float kAtSurface = 0.004;

/// Cosine to the eye's ray below which a pixel's plane says little about where its surface is.
const float kEdgeOn = 0.35;

/// One depth sample of the ray.
struct Sample {
    float share;
    vec2 px;
    float rayZ;
    float sceneZ;
};

/// The place in pixel `px` that is nearest to the ray's at `share`.
vec2 placeInPixel(ScreenRay ray, ivec2 px, float share) {
    return clamp(ray.startPX + ray.deltaPX * share, vec2(px), vec2(px) + 0.999);
}

/// At the place of pixel `px` that is nearest to the ray's at `share`.
Sample takeSample(ScreenRay ray, ivec2 px, float share, inout uint lookups) {
    Sample s;
    s.share = share;
    s.px = placeInPixel(ray, px, share);
    s.rayZ = rayViewZ(ray, share);
    s.sceneZ = loadSceneZ(px);
    ++lookups;
    logSample(ray, share, s.px, s.rayZ, s.sceneZ);
    return s;
}

Sample takeSample(ScreenRay ray, float share, inout uint lookups) {
    return takeSample(ray, floorToInt(ray.startPX + ray.deltaPX * share), share, lookups);
}

/// viewZ of the back of what the picture shows at `px`; `sceneZ` if it has none.
float backOf(vec2 px, float sceneZ, inout uint lookups) {
    if (!isOn(kTraceBackDepth))
        return sceneZ;
    float backZ = loadSceneBackZ(floorToInt(px), sceneZ);
    ++lookups;
    return backZ < kBackgroundZ ? backZ : sceneZ;
}

/// viewZ to which the surface that the picture shows at `px` reaches back.
float slabEnd(vec2 px, float sceneZ, inout uint lookups) {
    float reach = backOf(px, sceneZ, lookups) + settings.thickness + settings.thicknessRelative * sceneZ;
    logSlab(px, reach);
    return reach;
}

bool isOwnSurface(vec3 hitVS, vec3 hitNormalVS, Ray ray) {
    vec3 apart = ray.originVS - hitVS;
    return dot(hitNormalVS, ray.originNormalVS) > kOwnNormal &&
           abs(dot(hitNormalVS, apart)) <= kOwnPlane * length(apart);
}

/// Was the surface met from its front? From behind, the ray either grazes the surface that it starts from, where
/// shading normals disagree with depth, or meets a side that nobody sees.
bool facesRay(vec3 hitNormalVS, bool own, Ray ray) {
    return dot(hitNormalVS, -ray.directionVS) > (own ? 0.0 : kBackFaceLimit);
}

vec3 normalAt(vec2 px) {
    return loadSceneNormalVS(floorToInt(px));
}

// The results of the hit test are the decisions that inspection logs.
const uint kPasses = kSamplePasses;        // far behind the surface
const uint kMeets = kSampleHit;            // its front
const uint kMeetsSide = kSampleSide;       // its slab, from beside
const uint kMeetsBehind = kSampleBackFace; // its slab, from behind
const uint kGrazes = kSampleGrazes;        // its slab, but it is the surface that the ray starts from
const uint kNearlyMeets = kSampleNearly;   // a slab twice as thick would have been met
const uint kMeetsSunk = kSampleDecisionCount; // its front, from beside, just behind it: logged as kMeets
const uint kInFront = kSampleFront;        // in front of the surface's plane, behind the depth of the pixel's centre

/// The ray meets at `share` the plane of the surface that pixel `px` shows, in that pixel or just beside it: the pixel
/// there is taken if it shows the same surface, by plane and normal, so that positions are exact, else `px`, so that no
/// other surface lends its colour.
vec2 placeOfHit(ScreenRay ray, float share, ivec2 px, vec3 surfaceVS, vec3 normalVS, inout uint lookups) {
    vec2 at = ray.startPX + ray.deltaPX * share;
    ivec2 there = floorToInt(at);
    if (there != px && onScreen(at)) {
        float sceneZ = loadSceneZ(there);
        ++lookups;
        logPlace(ray, share, at, rayViewZ(ray, share), sceneZ);
        vec3 thereVS = viewPosition(frame.constants, (vec2(there) + 0.5) * frame.constants.invSize, sceneZ);
        if (abs(dot(normalVS, thereVS - surfaceVS)) <= kAtSurface * sceneZ && dot(normalAt(at), normalVS) > kOwnNormal)
            return at;
    }
    return clamp(at, vec2(px) + 0.001, vec2(px) + 0.999); // also once stored
}

/// So far behind a pixel's plane, in metres, a point may be that lay in front of the depth of a pixel's centre: as far
/// as the plane rises over half a pixel.
float planeSlack(vec3 normalVS, float sceneZ) {
    vec2 pixel = pixelExtent(frame.constants, frame.constants.uvToView, sceneZ);
    return 0.5 * dot(abs(normalVS.xy), pixel) + kDepthRounding * sceneZ;
}

/// A surface that the eye sees so nearly along its plane that the plane leaves the thing's depth within one pixel.
bool isEdgeOn(vec3 normalVS, vec3 surfaceVS) {
    return abs(dot(normalVS, viewDirection(frame.constants, surfaceVS))) < kEdgeOn;
}

/// Does the surface that pixel `px` shows edge-on end before its plane comes to `metZ`? It does where the next pixel, on
/// the side where the plane goes away from the eye, shows something far behind that does not lie on the plane: beyond
/// the rim of something round. A floor goes on there, however flat it is seen. So steep a plane comes near many depths:
/// what lies on it has its normal, too.
bool endsAsRim(ivec2 px, vec3 normalVS, vec3 surfaceVS, float metZ, inout uint lookups) {
    const float kStep = 0.05; // of nearness, as prepare/pyramid takes it for an edge
    vec2 slope = nearnessSlope(frame.constants, surfaceVS, normalVS);
    if (dot(normalVS, viewDirection(frame.constants, surfaceVS)) > 0.0)
        slope = -slope; // interpolated normals of rims turn away from the eye a little
    bool overX = abs(slope.x) > abs(slope.y);
    ivec2 next = px - (overX ? ivec2(sign(slope.x), 0) : ivec2(0, sign(slope.y)));
    float here = nearnessOf(frame.constants, -surfaceVS.z);
    float away = overX ? abs(slope.x) : abs(slope.y);
    float edge = kStep * abs(here);
    bool beside = metZ <= -surfaceVS.z || nearnessOf(frame.constants, metZ) >= here - min(away, edge);
    if (beside || !onScreen(vec2(next)))
        return false;
    float nextZ = loadSceneZ(next);
    ++lookups;
    float shown = nearnessOf(frame.constants, nextZ);
    bool onPlane = nextZ < kBackgroundZ && abs(shown - (here - away)) <= edge &&
                   dot(normalAt(vec2(next)), normalVS) > kOwnNormal;
    return shown < here - edge && !onPlane;
}

/// How a ray ended that reached its end on screen without an answer. `behind`: its end is behind the surface at
/// `sceneZ`; `nearlyThickEnough`: on its way, a slab of twice the thickness would have been hit. In front of the
/// background the outcome is `sky` if the rest of the way to the vanishing point is a few pixels: rays of full length
/// have come that far, rays that screen.maxDistance cut have not.
uint endedOnScreen(ScreenRay ray, float sceneZ, bool behind, bool nearlyThickEnough) {
    if (behind)
        return nearlyThickEnough ? kOutcomeTooThick : kOutcomeHidden;
    if (ray.clippedNear)
        return kOutcomeBehindCamera;
    const float kRest = 1.0 / 32.0; // of the picture's longer side
    // What the line still grows if the ray goes on without end: 1/w falls to 0 linearly.
    float toVanish = ray.endInvW / max(ray.startInvW - ray.endInvW, 1e-30);
    float longer = max(frame.constants.size.x, frame.constants.size.y);
    bool vanishes = toVanish * screenPixels(ray) <= kRest * longer;
    return sceneZ >= kBackgroundZ && vanishes ? kOutcomeSky : kOutcomeMaxDistance;
}

/// Where the ray crosses a plane, from its heights over the plane at two places: in front of it, and behind it.
float crossingShare(ScreenRay ray, float fromShare, float heightFrom, float share, float height) {
    // Heights are linear along the ray in 3D; over w, on screen.
    float from = heightFrom * mix(ray.startInvW, ray.endInvW, fromShare);
    float here = height * mix(ray.startInvW, ray.endInvW, share);
    return mix(fromShare, share, clamp(from / max(from - here, 1e-30), 0.0, 1.0));
}

uint testSurface(Ray r, float fromShare, inout Sample s, inout uint lookups) {
    ivec2 px = floorToInt(s.px);
    vec3 normalVS = normalAt(s.px);
    vec3 surfaceVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, s.sceneZ);
    vec2 fromPX = r.screen.startPX + r.screen.deltaPX * fromShare;
    vec2 herePX = r.screen.startPX + r.screen.deltaPX * s.share;
    float fromZ = rayViewZ(r.screen, fromShare);
    vec3 fromVS = viewPosition(frame.constants, fromPX * frame.constants.invSize, fromZ);
    vec3 hereVS = viewPosition(frame.constants, herePX * frame.constants.invSize, s.rayZ);
    float heightFrom = dot(normalVS, fromVS - surfaceVS);
    float heightHere = dot(normalVS, hereVS - surfaceVS);
    if (heightHere > 0.0 && heightFrom > 0.0)
        return kInFront;
    bool own = isOwnSurface(surfaceVS, normalVS, r);
    bool faces = facesRay(normalVS, own, r);
    if (faces && heightFrom >= -planeSlack(normalVS, s.sceneZ)) {
        float share = crossingShare(r.screen, fromShare, heightFrom, s.share, heightHere);
        if (isEdgeOn(normalVS, surfaceVS)) {
            // The rim of something closed: its plane goes on behind it, the thing does not.
            float backZ = backOf(s.px, s.sceneZ, lookups);
            float metZ = rayViewZ(r.screen, share);
            if (backZ > s.sceneZ && metZ > backZ + settings.thickness)
                return kPasses;
            float slab = settings.thickness + settings.thicknessRelative * s.sceneZ;
            if (backZ <= s.sceneZ && endsAsRim(px, normalVS, surfaceVS, metZ - slab, lookups))
                return kPasses;
        }
        s.share = share;
        s.px = placeOfHit(r.screen, s.share, px, surfaceVS, normalVS, lookups);
        return kMeets;
    }
    float nearest = min(s.rayZ, fromZ);
    float slabZ = slabEnd(s.px, s.sceneZ, lookups);
    if (nearest <= slabZ) {
        if (!faces)
            return own ? kGrazes : kMeetsBehind;
        return 0.5 * (s.rayZ + fromZ) <= s.sceneZ * (1.0 + kAtSurface) ? kMeetsSunk : kMeetsSide;
    }
    return nearest <= 2.0 * slabZ - s.sceneZ ? kNearlyMeets : kPasses;
}

/// Rays intersect a pixel's plane in the pixel, or up to this many pixels before it: the surface may begin there. Of the
/// hits that lie farther before it, in a pixel that shows another surface, about half are wrong
/// (lab/notes/hits.md).
const float kBeforePixel = 0.5;

/// A ray that is in front of the depth at the pixel's centre by less than this, in parts of that depth, may intersect the
/// pixel's plane before it leaves the pixel.
const float kNearlyBehind = 0.003;

/// May a ray that is in front of the depth at the pixel's centre intersect the pixel's plane before it leaves the pixel
/// at `leave`? The next pixel may show another surface. If so, moves the sample `s` to `leave`, for meetSurface.
bool mayMeetBeforeLeaving(Ray r, float leave, inout Sample s) {
    float leaveZ = rayViewZ(r.screen, leave);
    if (leaveZ < s.sceneZ * (1.0 - kNearlyBehind) || s.sceneZ >= kBackgroundZ)
        return false;
    s.share = leave;
    s.rayZ = leaveZ;
    return true;
}

/// Does the ray, on its way from `fromShare` to the sample `s`, meet the surface that the sample's pixel shows?
/// `s` moves to where it does. `inFront`: the ray is in front of the depth at the pixel's centre (mayMeetBeforeLeaving);
/// then only an intersection with the plane from its front counts. One call a marcher: the test is most of its code,
/// and the rays of a group test together.
uint meetSurface(Ray r, float fromShare, bool inFront, inout Sample s, inout March march) {
    vec2 px = s.px;
    uint met = testSurface(r, fromShare, s, march.lookups);
    if (inFront) {
        if (met != kMeets || s.share <= fromShare) // or behind the plane from the start on
            return kInFront;
    } else if (met == kPasses || met == kNearlyMeets) {
        passBehind(march, s.share);
    }
    logDecision(px, met == kInFront ? kPasses : met == kMeetsSunk ? kMeets : met);
    return met;
}

uint meetSurface(Ray r, float fromShare, inout Sample s, inout March march) {
    return meetSurface(r, fromShare, false, s, march);
}

bool isEnd(uint met) {
    return met == kMeets || met == kMeetsSunk || met == kMeetsSide || met == kMeetsBehind;
}

/// Ends the march if `met` ends it.
bool endsMarch(uint met, Sample s, inout March march) {
    if (!isEnd(met))
        return false;
    march.share = s.share;
    march.hitPX = s.px;
    march.sunk = met == kMeetsSunk;
    bool hit = met == kMeets || met == kMeetsSunk;
    march.outcome = hit ? kOutcomeHit : met == kMeetsSide ? kOutcomeSide : kOutcomeBackFace;
    return true;
}

#endif
