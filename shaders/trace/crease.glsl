// Hits beside a crease: an edge where two surfaces that the frame shows touch. Depth and normal of a pixel on either
// side give both planes, and so the crease between them, far more exactly than the pixels' grid: the surface that covers
// a place between the two centres is the one on whose side of the crease the place lies.
#ifndef GLINT_TRACE_CREASE_GLSL
#define GLINT_TRACE_CREASE_GLSL

#include "trace/hit_test.glsl"

/// The plane of the surface that a pixel shows.
struct ShownPlane {
    vec2 centerPX; // of the pixel
    vec3 pointVS;
    vec3 normalVS;
    float nearness; // at the pixel's centre
    vec2 slope;     // of nearness, from pixel to pixel
};

ShownPlane planeOf(vec2 px, float sceneZ, vec3 normalVS) {
    ShownPlane plane;
    plane.centerPX = floor(px) + 0.5;
    plane.pointVS = viewPosition(frame.constants, plane.centerPX * frame.constants.invSize, sceneZ);
    plane.normalVS = normalVS;
    plane.nearness = nearnessOf(frame.constants, sceneZ);
    plane.slope = nearnessSlope(frame.constants, plane.pointVS, plane.normalVS);
    return plane;
}

ShownPlane planeShown(vec2 px, float sceneZ) {
    return planeOf(px, sceneZ, normalAt(px));
}

float nearnessAt(ShownPlane plane, vec2 px) {
    return plane.nearness + dot(plane.slope, px - plane.centerPX);
}

float heightAt(Ray r, ShownPlane plane, float share) {
    vec3 rayVS = r.originVS + r.directionVS * rayDistance(r.screen, share);
    return dot(plane.normalVS, rayVS - plane.pointVS);
}

/// How far `px` lies beyond the crease between two planes, on the side of `beside`: 0 at the crease, 1 at the centre of
/// the pixel that shows `beside`. Negative on the side of `plane`, and where the two do not meet in a crease between
/// the centres, but one lies before the other.
float beyondCrease(ShownPlane plane, ShownPlane beside, vec2 px) {
    // Nearness of both planes is linear on screen: their difference is 0 on the crease.
    float atPlane = nearnessAt(beside, plane.centerPX) - plane.nearness;
    float atBeside = beside.nearness - nearnessAt(plane, beside.centerPX);
    return atPlane * atBeside < 0.0 ? (nearnessAt(beside, px) - nearnessAt(plane, px)) / atBeside : -1.0;
}

/// True if the pixel's normal differs from this one by so much that a crease may lie between them.
bool showsOtherFace(ivec2 px, vec3 normalVS) {
    return onScreen(vec2(px)) && dot(normalAt(vec2(px)), normalVS) <= kOwnNormal;
}

/// viewZ at a pixel of the hit's surroundings.
float besideHit(Ray r, ivec2 px, inout March hit) {
    float sceneZ = loadSceneZ(px);
    ++hit.lookups;
    logBeside(r.screen, hit.share, vec2(px) + 0.5, rayViewZ(r.screen, hit.share), sceneZ);
    return sceneZ;
}

/// Moves a hit to the surface that covers its place, where that is shown by one of the four pixels around it and lies
/// beyond a crease from the surface of the hit. Reads depth only where the four pixels' normals differ.
void moveOverCrease(Ray r, inout March end) {
    vec2 at = r.screen.startPX + r.screen.deltaPX * end.share;
    ivec2 px = floorToInt(end.hitPX);
    ivec2 corner = floorToInt(at - 0.5);
    vec3 normalVS = normalAt(end.hitPX);
    ShownPlane hit;
    bool known = false;
    float farthest = 0.0; // beyond a crease; in a corner of three surfaces the one that covers the place is farthest
    float pixelShare = 1.0 / screenPixels(r.screen);
    March moved = end;
    for (int i = 0; i < 4; ++i) {
        ivec2 other = corner + ivec2(i & 1, i >> 1);
        if (other == px || !showsOtherFace(other, normalVS))
            continue;
        if (!known)
            hit = planeOf(end.hitPX, besideHit(r, px, moved), normalVS);
        known = true;
        float otherZ = besideHit(r, other, moved);
        if (otherZ >= kBackgroundZ)
            continue;
        ShownPlane beside = planeShown(vec2(other), otherZ);
        float beyond = beyondCrease(hit, beside, at);
        if (beyond <= farthest || !facesRay(beside.normalVS, isOwnSurface(beside.pointVS, beside.normalVS, r), r))
            continue;
        farthest = beyond;
        float from = end.share - 1.5 * pixelShare;
        float to = end.share + 1.5 * pixelShare;
        moved.share = crossingShare(r.screen, from, heightAt(r, beside, from), to, heightAt(r, beside, to));
        moved.hitPX = clamp(r.screen.startPX + r.screen.deltaPX * moved.share, vec2(other) + 0.001, vec2(other) + 0.999);
    }
    end = moved;
}

#endif
