// The light that a clear coat takes from the layers below it: KHR_materials_clearcoat.
#ifndef GLINT_LIB_CLEARCOAT_GLSL
#define GLINT_LIB_CLEARCOAT_GLSL

#include "lib/brdf.glsl"
#include "lib/coat.glsl"
#include "lib/material.glsl"

float clampedNoV(vec3 N, vec3 V) {
    return clamp(dot(N, V), 1e-3, 1.0); // normal maps and interpolation may turn N away from the eye
}

/// Reflectance of the coat, which the layers below lose: KHR_materials_clearcoat, "Layering".
float coatReflectance(MaterialSample m, vec3 V) {
    return m.clearcoat * F_Schlick(vec3(kCoatF0), 1.0, clampedNoV(m.clearcoatNormalWS, V)).x;
}

/// F0 as the weight of reflections should use it: a layer below a coat loses what the coat reflects.
vec3 reflectionF0(MaterialSample m, vec3 V) {
    float coat = m.clearcoat > 0.0 ? coatReflectance(m, V) : 0.0;
    return m.f0 * (1.0 - coat);
}

#endif
