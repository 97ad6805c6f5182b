// The terms of glTF's microfacet model (glTF 2.0, appendix B), one function for each term. alpha =
// perceptualRoughness^2. The caller clamps cosines to (0, 1].
#ifndef GLINT_LIB_BRDF_GLSL
#define GLINT_LIB_BRDF_GLSL

#include "lib/math.glsl"

/// Punctual lights need a lobe of some width; below this a highlight is smaller than float's precision of NoH.
const float kMinPerceptualRoughnessDirect = 0.045;

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33 (Trowbridge-Reitz).
/// 1 / (pi alpha^2) at NoH = 1. Unclamped alpha = 0 is a mirror, which no punctual light can hit: keep alpha > 0.
float D_GGX(float NoH, float alpha) {
    const float a = NoH * alpha;
    const float k = alpha / (1.0 - NoH * NoH + a * a);
    return k * k / kPi;
}

/// Mean of D over the normals that reflect a disc of radius `radius` (slopes) around the normal at the slope `d` from the
/// middle. In the plane of slopes GGX is (alpha / (alpha^2 + slope^2))^2 / pi, which is the uniform density of a sphere
/// in stereographic projection: there the disc is a cap, whose share of the sphere is the integral. With a radius of 0
/// it is D, with alpha 0 the disc itself.
float D_GGXOverDisc(float NoH, float d2, float alpha, float radius) {
    float a2 = alpha * alpha;
    float r2 = radius * radius;
    float apart = d2 + a2 - r2;
    float root = sqrt(apart * apart + 4.0 * a2 * r2);
    float slopes = apart > 0.0 ? 2.0 * a2 / (root * (root + apart)) : (root - apart) / (2.0 * root * r2);
    return slopes / (kPi * square(NoH * NoH));
}

/// Heitz 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 99: height-correlated
/// G2 / (4 NoL NoV).
float V_SmithGGXCorrelated(float NoV, float NoL, float alpha) {
    const float a2 = alpha * alpha;
    const float ggxV = NoL * sqrt(NoV * NoV * (1.0 - a2) + a2);
    const float ggxL = NoV * sqrt(NoL * NoL * (1.0 - a2) + a2);
    return 0.5 / max(ggxV + ggxL, 1e-7);
}

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
vec3 F_Schlick(vec3 f0, float f90, float VoH) {
    return f0 + (f90 - f0) * pow5(1.0 - VoH);
}

/// Lambert: reflects the same radiance everywhere.
float Fd_Lambert() {
    return 1.0 / kPi;
}

/// Reflectance at normal incidence of a dielectric in air. `ior` 0 stands for infinite (KHR_materials_ior): 1.
float dielectricF0(float ior) {
    return ior == 0.0 ? 1.0 : square((ior - 1.0) / (ior + 1.0));
}

/// F90 that belongs to a dielectric's F0. At grazing angles every material reflects all light, except materials hardly
/// denser than air: Lagarde, de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", section 3.1.3:
/// from 2 % on.
float edgeReflectance(float f0) {
    return saturate(50.0 * f0);
}

/// Reflectance of a lobe under uniform light, from the split-sum table: Karis 2013, "Real Shading in Unreal Engine 4".
/// `dfg`: x multiplies f0, y multiplies f90.
vec3 directionalAlbedo(vec3 f0, float f90, vec2 dfg) {
    return f0 * dfg.x + f90 * dfg.y;
}

/// Compensates the energy that single scattering loses between the facets: Turquin 2019, "Practical multiple scattering
/// compensation for microfacet models", eq. 16. 1 for smooth surfaces; with f0 = 1 the albedo becomes exactly 1.
vec3 energyCompensation(vec3 f0, vec2 dfg) {
    return 1.0 + f0 * (1.0 / max(dfg.x + dfg.y, 1e-3) - 1.0);
}

/// Factor of a surface on reflected radiance: directional albedo with multiple scattering.
vec3 specularResponse(vec3 f0, float f90, vec2 dfg) {
    return directionalAlbedo(f0, f90, dfg) * energyCompensation(f0, dfg);
}

/// Fraction of the environment's specular light that reaches a point whose diffuse light is dimmed to `occlusion`.
/// Lagarde, de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0", listing 26.
float specularOcclusion(float NoV, float occlusion, float alpha) {
    return saturate(pow(NoV + occlusion, exp2(-16.0 * alpha - 1.0)) - 1.0 + occlusion);
}

#endif
