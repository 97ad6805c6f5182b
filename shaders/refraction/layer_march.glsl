// How the rays of a layer march on screen: by hiz, among the frame's surfaces alone, with settings of their own
// (refraction.*). The seam of trace/ray.glsl.
#ifndef GLINT_REFRACTION_LAYER_MARCH_GLSL
#define GLINT_REFRACTION_LAYER_MARCH_GLSL

#include "frame/prepared.glsl"
#include "lib/ray_record.glsl"
#include "lib/surface.glsl"
#include "shared/trace_constants.h"

TraceConstants settings = frame.settings.layerTrace;

#include "trace/hiz_march.glsl"

float loadSceneZ(ivec2 px) {
    return texelFetch(viewZ, px, 0).r;
}

vec3 loadSceneNormalVS(ivec2 px) {
    return unpackSurface(texelFetch(surface, px, 0).xy).normalVS;
}

/// Never asked: these settings have no kTraceBackDepth.
float loadSceneBackZ(ivec2 px, float sceneZ) {
    return kBackgroundZ;
}

/// True if the ray ends in the pixel that it starts from. The march begins behind that pixel.
bool endsInOwnPixel(Ray r, out float share) {
    bool overX;
    share = min(leaveCell(makeLine(r.screen), vec2(r.px), 1.0, overX), 1.0);
    float sceneZ = loadSceneZ(r.px);
    return rayViewZ(r.screen, share) >= sceneZ;
}

/// Marches through the depth pyramid and returns the outcome. `maxDistance` in metres. `endPX` and `distance`, metres
/// along the ray: where the march ended.
uint marchFrom(vec3 originVS, vec3 directionVS, vec3 normalVS, float maxDistance, out vec2 endPX, out float distance) {
    Ray r;
    r.originVS = originVS;
    r.originNormalVS = normalVS;
    r.directionVS = directionVS;
    r.screen = makeScreenRay(frame.constants, originVS, directionVS, maxDistance);
    endPX = r.screen.startPX;
    distance = 0.0;
    if (-originVS.z < frame.constants.nearZ)
        return kOutcomeBehindCamera;
    if (!onScreen(endPX))
        return kOutcomeOffScreen;
    r.px = ivec2(endPX);
    float startZ = loadSceneZ(r.px);
    if (rayViewZ(r.screen, 0.0) > startZ * (1.0 + kAtSurface))
        return kOutcomeHidden; // it starts behind a surface
    float share;
    if (endsInOwnPixel(r, share)) {
        endPX = clamp(r.screen.startPX + r.screen.deltaPX * share, vec2(r.px), vec2(r.px) + 0.999);
        distance = max(startZ + originVS.z, 0.0) / max(-directionVS.z, 1e-3);
        return kOutcomeHit;
    }
    March end = march(r);
    distance = rayDistance(r.screen, end.share);
    endPX = isAnswered(end.outcome) ? end.hitPX : r.screen.startPX + r.screen.deltaPX * end.share;
    return end.outcome;
}

#endif
