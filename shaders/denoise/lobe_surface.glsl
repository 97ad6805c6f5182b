// A pixel's reflecting surface as the passes of the denoiser compare it. View space.
#ifndef GLINT_DENOISE_LOBE_SURFACE_GLSL
#define GLINT_DENOISE_LOBE_SURFACE_GLSL

#include "frame/prepared.glsl"
#include "generate/lobe.glsl"
#include "lib/camera.glsl"
#include "lib/surface.glsl"

struct LobeSurface {
    vec3 positionVS;
    vec3 normalVS;
    vec3 shownNormalVS; // as the picture shows it: of the image, behind a mirror (denoise/averaged_surface.glsl)
    vec3 toEyeVS;       // behind a mirror: to the mirror
    float viewZ;        // at which a pixel is as wide as on the surface
    float perceptualRoughness;
    bool isMirrored;
};

/// Of the surface that the pixel shows.
LobeSurface lobeSurfaceAt(ivec2 px) {
    LobeSurface at;
    at.viewZ = texelFetch(viewZ, px, 0).r;
    Surface here = unpackSurface(texelFetch(surface, px, 0).xy);
    at.positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, at.viewZ);
    at.normalVS = at.shownNormalVS = here.normalVS;
    at.toEyeVS = -viewDirection(frame.constants, at.positionVS);
    at.perceptualRoughness = here.perceptualRoughness;
    at.isMirrored = false;
    return at;
}

/// Metres to where a ray ended whose nearness (1 / metres) is stored. Rays that end farther away than this limit count as
/// parallel.
float endDistance(float near) {
    const float kFar = 1e4;
    return near > 1.0 / kFar ? 1.0 / near : kFar;
}

bool isInFrame(ivec2 px) {
    return all(greaterThanEqual(px, ivec2(0))) && all(lessThan(px, ivec2(frame.constants.size)));
}

/// True if the previous frame has a pixel there.
bool wasInFrame(ivec2 px) {
    return all(greaterThanEqual(px, ivec2(0))) && all(lessThan(px, ivec2(frame.constants.prevSize)));
}

/// True where `other` shows the surface of `here`: near its plane (a fraction of viewZ), with a similar normal and
/// roughness.
bool isSameSurface(LobeSurface here, LobeSurface other) {
    const float kPlane = 0.005;
    const float kNormal = 0.7;
    float fromPlane = abs(dot(here.normalVS, other.positionVS - here.positionVS));
    return here.isMirrored == other.isMirrored && other.viewZ < kBackgroundZ && fromPlane <= kPlane * here.viewZ &&
           dot(here.normalVS, other.normalVS) > kNormal &&
           abs(here.perceptualRoughness - other.perceptualRoughness) < 0.1 + 0.2 * here.perceptualRoughness;
}

/// Points of a disc, evenly spread: Vogel's spiral. Each point is turned from the one before by the golden angle.
struct Spiral {
    vec2 direction;
    float perPoint; // 1 / number of points
};

/// `turn`: a random angle in turns.
Spiral beginSpiral(uint count, float turn) {
    float angle = turn * 2.0 * kPi;
    return Spiral(vec2(cos(angle), sin(angle)), 1.0 / float(count));
}

/// Point `i`, in the unit disc. Call it for every `i` from 0 on, in turn.
vec2 nextPoint(inout Spiral spiral, uint i) {
    const mat2 kGoldenAngle = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888); // 2.39996323 radians
    vec2 point = sqrt((float(i) + 0.5) * spiral.perPoint) * spiral.direction;
    spiral.direction = kGoldenAngle * spiral.direction;
    return point;
}

/// A disc around a pixel, drawn out along the normal's direction on screen: there a lobe reaches 1 / NoV farther than
/// across.
mat2 lobeDisc(LobeSurface at, float radius) {
    float NoV = clamp(dot(at.normalVS, at.toEyeVS), 0.1, 1.0);
    vec2 along = vec2(at.shownNormalVS.x, -at.shownNormalVS.y); // pixels: y down
    float tilt = length(along);
    along = tilt > 1e-3 ? along / tilt : vec2(0.0, 1.0);
    vec2 across = vec2(-along.y, along.x);
    return mat2(along * radius, across * max(radius * NoV, 1.0));
}

#endif
