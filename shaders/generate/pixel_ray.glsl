// The one ray of a pixel, which every source answers for: where it starts, its direction, and the roughness that is left
// for prefiltered lookups. Screen, planar mirrors, probes and sky take it from here. Sources that sample the lobe around
// that direction draw from generate/lobe.glsl.
//
// A function and not an image: a direction in full precision is 16 bytes a pixel, which four passes would read instead
// of the 8 bytes of packed surface that they read anyway.
#ifndef GLINT_GENERATE_PIXEL_RAY_GLSL
#define GLINT_GENERATE_PIXEL_RAY_GLSL

#include "frame/frame_block.glsl"
#include "lib/camera.glsl"
#include "lib/surface.glsl"

struct PixelRay {
    vec3 originVS;       // metres: the surface
    vec3 directionVS;    // unit
    float roughnessLeft; // perceptual: of the lobe around the direction, for lookups that are filtered by roughness
};

/// The mirror direction; the whole lobe is left to filtered lookups.
PixelRay generateRay(vec3 positionVS, Surface here) {
    vec3 toSurfaceVS = viewDirection(frame.constants, positionVS);
    return PixelRay(positionVS, reflect(toSurfaceVS, here.normalVS), here.perceptualRoughness);
}

/// Of the pixel with this centre, whose surface is at `viewZ` metres.
PixelRay generateRay(vec2 uv, float viewZ, Surface here) {
    return generateRay(viewPosition(frame.constants, uv, viewZ), here);
}

vec3 directionWS(PixelRay ray) {
    return mat3(frame.constants.viewToWorld) * ray.directionVS;
}

#endif
