// A ray and its hit, for hosts that shade hits themselves: glint::RayHit.
#ifndef GLINT_SHARED_RAY_HIT_H
#define GLINT_SHARED_RAY_HIT_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct RayHitRecord {
    uint pixel; ///< x in the low half, y in the high one
    float distance;
    uint instance; ///< kNoInstance: miss
    uint primitive;
    float2 barycentrics;
    uint frontFace;
    float coneWidth; ///< metres, at the hit
    float3 originWS;
    float3 directionWS;
};

GLINT_SHARED_END
#endif
