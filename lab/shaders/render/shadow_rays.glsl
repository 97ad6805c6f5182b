// Visibility of each light by rays through the scene: lights.shadows rays.
#ifndef GLINT_RENDER_SHADOW_RAYS_GLSL
#define GLINT_RENDER_SHADOW_RAYS_GLSL

#include "render/shadow_geometry.glsl"

#include "rays/back_end.glsl"

#include "lib/ray_start.glsl"

/// Face normal of the drawn triangle, towards the eye. Shadow rays start off the triangle, as they do at rays' hits,
/// because a bent normal may lie below it.
vec3 drawnFaceNormalWS;

/// Call first in main: derivatives need the whole quad.
void beginLighting() {
    vec3 normalWS = cross(dFdx(positionWS), dFdy(positionWS));
    vec3 towardsEye = view.constants.orthographic != 0u ? -view.constants.cameraForwardWS
                                                        : view.constants.cameraPositionWS - positionWS;
    drawnFaceNormalWS = normalizeOr(dot(normalWS, towardsEye) < 0.0 ? -normalWS : normalWS, normalWS);
}

float loadLightVisibility(Light light, vec3 position, vec3 geometricNormal, vec3 L) {
    float offset = rasterUncertainty(position);
    float reach = light.type == kLightDirectional ? 1e30 : max(distance(light.positionWS, position) - offset, 0.0);
    Ray ray = makeRay(position + drawnFaceNormalWS * offset, L, 0.0, reach);
    ray.mask = kShadowMask;
    ray.flags = 0u; // any occluder blocks the light, hit from either side
    return isOccluded(ray) ? 0.0 : 1.0;
}

#endif
