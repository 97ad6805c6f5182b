// Where the picture's pixels do not say for certain what stands between their centres. Include after rays_inputs.glsl,
// or what list.comp declares in its place.
#ifndef GLINT_RAYS_SHOWN_EDGE_GLSL
#define GLINT_RAYS_SHOWN_EDGE_GLSL

#include "lib/camera.glsl"
#include "lib/surface.glsl"

/// A surface seen by two pixels: within this share of its distance and a quarter of a pixel on one plane.
const float kSamePlace = 0.002;

float samePlaceSlack(float viewZ) {
    return kSamePlace * viewZ + 0.25 * pixelExtent(frame.constants, frame.constants.uvToView, viewZ).y;
}

bool showSame(ivec2 px, ivec2 neighbour) {
    neighbour = clamp(neighbour, ivec2(0), ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, px, 0).r;
    float neighbourZ = texelFetch(viewZ, neighbour, 0).r;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    Surface there = unpackSurface(texelFetch(surface, neighbour, 0).xy);
    vec3 hereVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    vec3 thereVS = viewPosition(frame.constants, (vec2(neighbour) + 0.5) * frame.constants.invSize, neighbourZ);
    const float kLike = 0.7;          // of normals: 45 degrees
    const float kLikeMaterial = 0.25; // of reflectivity and roughness
    return neighbourZ < kBackgroundZ && abs(dot(here.normalVS, thereVS - hereVS)) <= samePlaceSlack(z) &&
           dot(here.normalVS, there.normalVS) > kLike && abs(here.reflectivity - there.reflectivity) < kLikeMaterial &&
           abs(here.perceptualRoughness - there.perceptualRoughness) < kLikeMaterial;
}

/// Does the picture change its surface between the centre of the pixel in which `at` lies, in pixels, and the centres
/// of the next ones on that side? Then it does not say which of them is at `at`.
bool isAtEdge(vec2 at) {
    ivec2 px = ivec2(at);
    ivec2 side = ivec2(sign(at - vec2(px) - 0.5));
    return !showSame(px, px + ivec2(side.x, 0)) || !showSame(px, px + ivec2(0, side.y));
}

#endif
