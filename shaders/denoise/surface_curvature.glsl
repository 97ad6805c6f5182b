// How a pixel's surface is curved, by the normals of the pixels around.
#ifndef GLINT_DENOISE_SURFACE_CURVATURE_GLSL
#define GLINT_DENOISE_SURFACE_CURVATURE_GLSL

#include "denoise/lobe_surface.glsl"

/// From one neighbour of a pixel to the opposite one: the way, and how the normal turns on it. 0 where neither shows the
/// pixel's surface.
struct SurfaceStep {
    vec3 way;
    vec3 turn;
};

LobeSurface neighbourOnSurface(LobeSurface here, ivec2 px) {
    if (!isInFrame(px))
        return here;
    LobeSurface other = lobeSurfaceAt(px);
    return isSameSurface(here, other) ? other : here;
}

SurfaceStep surfaceStep(ivec2 px, LobeSurface here, ivec2 by) {
    LobeSurface from = neighbourOnSurface(here, px - by);
    LobeSurface to = neighbourOnSurface(here, px + by);
    return SurfaceStep(to.positionVS - from.positionVS, to.normalVS - from.normalVS);
}

/// Normal curvatures along the tangents `a` and `b`, which are perpendicular: 1 / metres, convex > 0. False where the two
/// steps do not span the surface.
bool curvatureOf(SurfaceStep x, SurfaceStep y, vec3 a, vec3 b, out vec2 curvature) {
    vec2 alongX = vec2(dot(x.way, a), dot(x.way, b));
    vec2 alongY = vec2(dot(y.way, a), dot(y.way, b));
    float area = alongX.x * alongY.y - alongY.x * alongX.y;
    if (abs(area) <= 0.01 * length(alongX) * length(alongY))
        return false;
    vec3 turnA = (alongY.y * x.turn - alongX.y * y.turn) / area;
    vec3 turnB = (alongX.x * y.turn - alongY.x * x.turn) / area;
    curvature = vec2(dot(turnA, a), dot(turnB, b));
    return true;
}

#endif
