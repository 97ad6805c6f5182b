// The clear coat over a host's surface: KHR_materials_clearcoat. The library keeps it as a surface of its own beside the
// one below, packed alike (lib/surface.glsl), with the same reflectivity as any other dielectric.
#ifndef GLINT_LIB_COAT_GLSL
#define GLINT_LIB_COAT_GLSL

#include "lib/brdf.glsl"

const float kCoatF0 = 0.04; // KHR_materials_clearcoat: ior 1.5

/// Fraction of reflected light that a coat sends to the eye, and that the surface below it loses: KHR_materials_clearcoat,
/// "Layering". `reflectivity`: of the coat's packed surface, F0 times its strength.
float coatReflectance(float reflectivity, float NoV) {
    return reflectivity / kCoatF0 * F_Schlick(vec3(kCoatF0), 1.0, NoV).x;
}

#endif
