// Punctual lights (KHR_lights_punctual) and their shadow maps.
#ifndef GLINT_SHARED_LIGHT_H
#define GLINT_SHARED_LIGHT_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kLightDirectional, 0u);
GLINT_CONSTANT(uint, kLightPoint, 1u);
GLINT_CONSTANT(uint, kLightSpot, 2u);

GLINT_CONSTANT(uint, kMaxLights, 256u); ///< per scene; later lights are left out, with a warning

struct Light {
    uint type;    ///< kLight...
    float3 color; ///< times intensity: candela (point, spot) or lux (directional)
    float3 positionWS;
    float3 directionWS;  ///< unit, direction in which the light travels
    float range;         ///< metres; 0: infinite
    float angularRadius; ///< radians, of the disc that a directional light is; 0: a point
    float spotScale;     ///< cone falloff = saturate(cos * spotScale + spotOffset)^2
    float spotOffset;
    uint castsShadow;       ///< 1: the fields below are set
    float4x4 worldToShadow; ///< -> xy in [0, 1] of the light's tile, reversed depth, w
    float4 shadowTile;      ///< atlas UV: origin, size
    float shadowTexelSize;  ///< world size of one texel: metres (directional), or metres for each metre of distance
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::Light) == 4 * 36);
#endif
#endif
