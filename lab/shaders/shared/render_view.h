// The constants of one rendered view: camera, environment, counts. Set once a frame.
#ifndef GLINT_SHARED_RENDER_VIEW_H
#define GLINT_SHARED_RENDER_VIEW_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kMaxSuns, 4u);

/// The disc of a sun or lamp of the environment, in the background.
struct SunDisc {
    float3 directionWS; ///< unit, towards it
    float cosRadius;    ///< cosine of the disc's angular radius; 2: no disc
    float3 radiance;
};

struct RenderView {
    float4x4 worldToClip;
    float4x4 clipToWorld;
    float4x4 prevWorldToClip;
    float4 worldToViewZ; ///< viewZ = dot(worldToViewZ, (positionWS, 1)), positive distance
    float4 prevWorldToViewZ;
    float2 jitterUV; ///< offset by which worldToClip shifts the image; motion excludes it
    float2 prevJitterUV;
    float3 cameraPositionWS;
    uint orthographic; ///< 1: every camera ray runs along cameraForwardWS
    float3 cameraForwardWS;
    uint lightCount;
    float2 environmentRotation; ///< cos and sin of the angle about +Y
    float environmentStrength;
    uint environmentVisible; ///< 1: drawn as the background
    SunDisc suns[kMaxSuns];
    float4 clipPlaneWS; ///< surfaces are drawn where dot(xyz, positionWS) + w > 0
    uint highlights;    ///< 1: smooth surfaces show lights' highlights
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::RenderView) == 3 * 64 + 4 * (29 + 4 * 7));
#endif
#endif
