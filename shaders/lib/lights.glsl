// Punctual lights: the irradiance that arrives at a point. KHR_lights_punctual, "Light Shared Properties" and "Inner
// and Outer Cone Angles". Shadows are separate (lib/shadow.glsl).
#ifndef GLINT_LIB_LIGHTS_GLSL
#define GLINT_LIB_LIGHTS_GLSL

#include "lib/math.glsl"
#include "shared/light.h"

struct Incidence {
    vec3 L;          // unit, towards the light
    vec3 irradiance; // on a surface that faces the light; zero out of range
    float angularRadius; // radians, of the light's disc; 0: a point
};

/// Inverse square, falling smoothly to zero at `range` metres (0: no limit).
float distanceAttenuation(float distance2, float range) {
    float window = range > 0.0 ? saturate(1.0 - square(distance2 / (range * range))) : 1.0;
    return window / max(distance2, 1e-8);
}

Incidence lightAt(Light light, vec3 positionWS) {
    if (light.type == kLightDirectional)
        return Incidence(-light.directionWS, light.color, light.angularRadius);
    vec3 toLight = light.positionWS - positionWS;
    float distance2 = dot(toLight, toLight);
    Incidence result;
    result.L = toLight * inversesqrt(max(distance2, 1e-12));
    result.angularRadius = 0.0;
    result.irradiance = light.color * distanceAttenuation(distance2, light.range);
    if (light.type == kLightSpot)
        result.irradiance *= square(saturate(dot(-result.L, light.directionWS) * light.spotScale + light.spotOffset));
    return result;
}

#endif
