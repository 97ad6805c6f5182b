// Rough surfaces' answers without noise: the mean of the traced answers around over the surface's lobe. On a smooth
// surface the mirror rays of neighbouring pixels show a mirrored image, and the lobe has a shape on it: long in the
// plane of incidence, narrow across, narrower towards what is near. Misses are part of the mean, so that a lamp before
// the night sky is as wide as one before a wall. Where too little of the lobe lies on the surface, or its bumps turn
// the rays by more than the lobe, the answer is the mean of the frame around the pixel's own hit (trace/cone.glsl).
// docs/techniques/cones.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "frame/prepared.glsl"
#include "generate/pixel_ray.glsl"
#include "lib/lobe_shape.glsl"
#include "lib/nearness.glsl"
#include "shared/lobe_mean.h"
#include "shared/trace_constants.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 4, rgba16f) uniform image2D radianceWeight; // of the traced pixels
layout(set = 0, binding = 5) uniform sampler2D lights;                // resolve/lobe_take.comp
layout(set = 0, binding = 9) uniform usampler2D rayRecord;
layout(set = 0, binding = 10) uniform sampler2D places;
layout(scalar, set = 0, binding = 11) readonly buffer RaysBlock {
    RayListHeader header;
}
rayList;

#include "resolve/neighbourhood.glsl"
#include "trace/hit_color.glsl" // bindings 3, 6, 7, 8, 46

/// Perceptual roughness up to which the answers around make the mean, and from which on the frame around the hit does.
const float kNarrowLobe = 0.25;
const float kWideLobe = 0.45;

/// Of a narrow lobe this share tells of the rest more than the frame around the hit, which may lie in other depths.
const float kEnough = 0.4;

/// How directions turn from one traced pixel to the next, along the axes of a ray's lobe.
struct Turns {
    mat2 mirror; // of the mirror directions
    mat2 moved;  // of the pixels' places, times 1 / metres: of the directions to a point at that distance
};

/// The change from the pixel to `px`, a step away, or a negative step; false if that shows another surface.
bool changeTo(ivec2 px, Place here, vec3 directionVS, LobeAxes axes, out vec2 turned, out vec2 moved) {
    if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, ivec2(frame.constants.size))))
        return false;
    Place there = placeOf(px);
    const float kSame = 0.2;
    if (there.reflectivity <= 0.0 || sameSurface(here, there, 1.0) < kSame)
        return false;
    vec3 thereVS = reflect(viewDirection(frame.constants, there.positionVS), there.normalVS);
    turned = alongAxes(axes, thereVS - directionVS);
    moved = alongAxes(axes, there.positionVS - here.positionVS);
    return true;
}

/// Half the difference of the two neighbours, or that to the one that shows the surface. Without one: false.
bool turnsAlong(int axis, ivec2 px, Place here, vec3 directionVS, LobeAxes axes, inout Turns turns) {
    ivec2 step = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    vec2 turned[2];
    vec2 moved[2];
    bool after = changeTo(px + step, here, directionVS, axes, turned[0], moved[0]);
    bool before = changeTo(px - step, here, directionVS, axes, turned[1], moved[1]);
    float scale = frame.constants.traceScale[axis];
    if (after && before) {
        turns.mirror[axis] = 0.5 * scale * (turned[0] - turned[1]);
        turns.moved[axis] = 0.5 * scale * (moved[0] - moved[1]);
    } else {
        float sign = after ? scale : -scale;
        turns.mirror[axis] = sign * (after ? turned[0] : turned[1]);
        turns.moved[axis] = sign * (after ? moved[0] : moved[1]);
    }
    return after || before;
}

/// A pixel's surface on the screen, as an infinite plane.
struct Plane {
    vec2 px; // traced
    float nearness;
    vec2 slope; // of nearness, per traced pixel
};

/// 1 where texels of nearness `nearness` show the plane at `px`; 0 where they show, or also show, something else.
float liesOn(Plane plane, vec2 px, float nearness) {
    const float kOff = 0.02; // fraction
    float expected = plane.nearness + dot(plane.slope, px - plane.px);
    float off = abs(nearness - expected) / max(abs(expected), 1e-9);
    bool behindEye = expected <= 0.0 && !isOrthographic(frame.constants);
    return behindEye ? 0.0 : 1.0 - smoothstep(kOff, 2.0 * kOff, off);
}

/// Radiance * weight, weight; and what of the lobe these are known for.
struct LobeMean {
    vec4 light;
    float known;
    float whole;
};

const float kDark = 1e-6; // brightness of which the distance is not known

/// 1 / metres from a surface, `before` metres from the eye, to what it reflects, of places of `places`. Neighbours
/// reflect it at the end of a way of the same length: at a mirror all of them see one image behind it.
float nearnessIn(vec4 place, float before) {
    const float kLeastPart = 0.02; // of the way to the surface
    if (place.w <= kDark || place.z <= 0.0)
        return 0.0;
    return 1.0 / max(place.w / place.z - before, kLeastPart * before);
}

/// How wide the lobe is on the screen where what it shows is 1 / `nearness` metres away, in any unit.
float widthAt(Turns turns, float nearness) {
    return inversesqrt(max(abs(determinant(turns.mirror + nearness * turns.moved)), 1e-14));
}

/// Adds one of the Gaussians that make the lobe, whose `ellipse` was made for `nearness`.
void addPart(inout LobeMean sum, float share, LobeEllipse ellipse, float nearness, Plane plane, LobeAxes axes,
             Turns turns, float before) {
    const int kMostToSide = 3;
    LobeTaps taps = lobeTaps(ellipse, kMostToSide, float(kLobeMips - 1u));
    mat2 turn = turns.mirror + nearness * turns.moved;
    float width = widthAt(turns, nearness);
    vec2 size = vec2(textureSize(lights, 0));
    float weights = 0.0;
    vec4 light = vec4(0.0);
    float known = 0.0;
    for (int i = -taps.side; i <= taps.side; ++i) {
        vec2 offset = float(i) * taps.spacing * ellipse.along;
        vec2 px = plane.px + offset;
        float weight = tapWeight(taps, i) * facetVisible(axes, (turn * offset).x);
        weights += weight;
        vec4 place = textureLod(places, px / size, taps.mip);
        if (weight <= 0.0 || place.x <= 0.0 || any(lessThan(px, vec2(0.0))) ||
            any(greaterThanEqual(px, frame.constants.traceSize)))
            continue;
        weight *= liesOn(plane, px, place.y / place.x);
        vec4 shown = textureLod(lights, px / size, taps.mip);
        float away = float(i) * taps.spacing / max(ellipse.longPX, 1e-3);
        float ratio = place.w > kDark ? widthAt(turns, nearnessIn(place, before)) / width : 1.0;
        float narrower = narrowerLobe(ellipse, taps, away, ratio);
        known += weight * (place.x - (1.0 - narrower) * shown.a); // the rest are misses
        light += weight * narrower * shown;
    }
    sum.whole += share;
    if (weights > 0.0) {
        sum.light += share / weights * light;
        sum.known += share / weights * known;
    }
}

/// The mean over the lobe of a pixel. `radius`: standard deviation of its widest part, pixels.
LobeMean lobeMean(vec2 px, Place here, LobeAxes axes, Turns turns, out float radius) {
    Plane plane = Plane(px, nearnessOf(frame.constants, -here.positionVS.z),
                        nearnessSlope(frame.constants, here.positionVS, here.normalVS) * frame.constants.traceScale);
    float before = length(here.positionVS);
    vec2 size = vec2(textureSize(places, 0));
    vec4 own = texelFetch(places, ivec2(px), 0);
    LobeMean sum = LobeMean(vec4(0.0), 0.0, 0.0);
    radius = 0.0;
    for (int i = 0; i < kLobeParts; ++i) {
        vec2 widths = lobeWidths(axes, square(here.perceptualRoughness), i);
        LobeEllipse farthest = lobeEllipse(turns.mirror, widths);
        float mip = min(lobeMip(sqrt(farthest.longPX * farthest.shortPX)), float(kLobeMips - 1u));
        vec4 around = textureLod(places, px / size, mip);
        // Where the pixel's own hit is as bright as what is around, its distance is known and not a mean.
        float known = clamp(own.w / max(around.w, kDark), 0.0, 1.0);
        float nearness = mix(nearnessIn(around, before), nearnessIn(own, before), known);
        LobeEllipse ellipse = lobeEllipse(turns.mirror + nearness * turns.moved, widths);
        addPart(sum, kLobeShares[i], ellipse, nearness, plane, axes, turns, before);
        radius = max(radius, ellipse.longPX);
    }
    return sum;
}

void main() {
    ivec2 tracePX = ivec2(gl_GlobalInvocationID.xy);
    if (!isTracePixel(frame.constants, tracePX) || rayList.header.pictureGroups[0] == 0u)
        return;
    RayRecord ray = rayOf(tracePX);
    ivec2 px = tracePixelToFull(frame.constants, tracePX);
    Place here = placeOf(px);
    if (!wasTraced(ray) || isMirror(here.perceptualRoughness))
        return;
    vec3 directionVS = reflect(viewDirection(frame.constants, here.positionVS), here.normalVS);
    // The surface hardly ever shows all of a wide lobe. The frame around the hit shows more of it.
    float narrow = 1.0 - smoothstep(kNarrowLobe, kWideLobe, here.perceptualRoughness);
    LobeAxes axes = lobeAxes(directionVS, here.normalVS);
    Turns turns;
    LobeMean mean = LobeMean(vec4(0.0), 0.0, 1.0);
    float radius = 0.0;
    if (narrow > 0.0 && turnsAlong(0, px, here, directionVS, axes, turns) &&
        turnsAlong(1, px, here, directionVS, axes, turns))
        mean = lobeMean(vec2(tracePX) + 0.5, here, axes, turns, radius);
    float share = min(mean.known / (kEnough * mean.whole), 1.0) * smoothstep(0.2, 0.6, radius) * narrow;

    vec4 own = imageLoad(radianceWeight, tracePX);
    if (isAnswered(ray.outcome)) {
        if (share < 1.0) {
            uint lookups = 0u; // only rays count lookups
            vec3 hitVS = here.positionVS + directionVS * ray.hitDistance;
            LobeCone cone = makeCone(directionVS, here.normalVS, here.perceptualRoughness);
            own.rgb = hitRadiance(ray.hitUV * frame.constants.size, ray.outcome == kOutcomeHit, here.positionVS, hitVS,
                                  cone, lookups);
        }
    }
    vec4 premultiplied = vec4(own.rgb * own.a, own.a);
    if (mean.known > 0.0)
        premultiplied = mix(premultiplied, mean.light / mean.known, share);
    imageStore(radianceWeight, tracePX,
               vec4(premultiplied.a > 0.0 ? premultiplied.rgb / premultiplied.a : vec3(0.0), premultiplied.a));
}
