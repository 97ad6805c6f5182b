// What a pixel of the frame can tell about a ray's hit on its surface. A pixel does not tell what lies between its
// centre and the next, nor how a glossy surface looks from elsewhere. Include after rays_inputs.glsl, or after
// list.comp's own declarations of the same inputs.
#ifndef GLINT_RAYS_SHOWN_PIXEL_GLSL
#define GLINT_RAYS_SHOWN_PIXEL_GLSL

#include "lib/camera.glsl"
#include "lib/surface.glsl"
#include "frame/lobe_surfaces.glsl"

/// Two pixels show one surface if they lie on one plane, within this fraction of the distance and a quarter of a pixel.
const float kSamePlace = 0.002;

float samePlaceSlack(float viewZ) {
    return kSamePlace * viewZ + 0.25 * pixelExtent(frame.constants, frame.constants.uvToView, viewZ).y;
}

bool showSame(ivec2 px, ivec2 neighbour) {
    neighbour = clamp(neighbour, ivec2(0), ivec2(frame.constants.size) - 1);
    float z = texelFetch(viewZ, px, 0).r;
    float neighbourZ = texelFetch(viewZ, neighbour, 0).r;
    Surface here = shownAt(px);
    Surface there = shownAt(neighbour);
    vec3 hereVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    vec3 thereVS = viewPosition(frame.constants, (vec2(neighbour) + 0.5) * frame.constants.invSize, neighbourZ);
    const float kLike = 0.7;          // of normals: 45 degrees
    const float kLikeMaterial = 0.25; // of reflectivity and roughness
    return neighbourZ < kBackgroundZ && abs(dot(here.normalVS, thereVS - hereVS)) <= samePlaceSlack(z) &&
           dot(here.normalVS, there.normalVS) > kLike && abs(here.reflectivity - there.reflectivity) < kLikeMaterial &&
           abs(here.perceptualRoughness - there.perceptualRoughness) < kLikeMaterial;
}

/// True if the frame changes its surface between the centre of the pixel that contains `at` (in pixels) and the centres
/// of the next pixels on that side. The frame then does not tell which surface is at `at`.
bool isAtEdge(vec2 at) {
    ivec2 px = ivec2(at);
    ivec2 side = ivec2(sign(at - vec2(px) - 0.5));
    return !showSame(px, px + ivec2(side.x, 0)) || !showSame(px, px + ivec2(0, side.y));
}

/// True if this surface looks the same from where rays come from as from the eye. A glossy surface does not: its
/// highlights are those that the eye sees. A perfect mirror's highlights are too small to matter.
bool looksAlike(Surface here) {
    const float kPerfect = 0.001;
    return here.reflectivity <= settings.threshold || here.perceptualRoughness >= settings.reuseRoughness ||
           here.perceptualRoughness < kPerfect;
}

#endif
