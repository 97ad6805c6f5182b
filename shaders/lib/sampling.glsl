// Points in the unit square, and directions generated from them.
#ifndef GLINT_LIB_SAMPLING_GLSL
#define GLINT_LIB_SAMPLING_GLSL

#include "lib/math.glsl"

/// Hammersley's point set: point `i` of `count`, in [0, 1)^2. Dammertz 2012, "Hammersley Points on the Hemisphere". The
/// first coordinate is the middle of its interval, which halves the error of sums over few points.
vec2 hammersley(uint i, uint count) {
    return vec2((float(i) + 0.5) / float(count), float(bitfieldReverse(i)) * 2.3283064365386963e-10);
}

/// A microfacet normal with density D(wm) cos(wm), around +Z. Walter et al. 2007, eqs. 35 and 36.
vec3 sampleGGX(vec2 u, float alpha) {
    const float cosTheta2 = (1.0 - u.x) / (1.0 + (alpha * alpha - 1.0) * u.x);
    const float sinTheta = sqrt(max(1.0 - cosTheta2, 0.0));
    const float phi = 2.0 * kPi * u.y;
    return vec3(sinTheta * cos(phi), sinTheta * sin(phi), sqrt(cosTheta2));
}

/// A microfacet normal among those visible from `wo` (unit, wo.z > 0), with density D_wo(wm) = G1(wo) max(dot(wo, wm),
/// 0) D(wm) / wo.z. Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4).
vec3 sampleGGXVisible(vec3 wo, vec2 u, float alpha) {
    const vec3 stretched = normalize(vec3(alpha * wo.xy, wo.z));
    const float length2 = dot(stretched.xy, stretched.xy);
    const vec3 t1 = length2 > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) * inversesqrt(length2) : vec3(1.0, 0.0, 0.0);
    const vec3 t2 = cross(stretched, t1);
    const float r = sqrt(u.x);
    const float phi = 2.0 * kPi * u.y;
    const float p1 = r * cos(phi);
    const float s = 0.5 * (1.0 + stretched.z);
    const float p2 = mix(sqrt(max(1.0 - p1 * p1, 0.0)), r * sin(phi), s);
    const vec3 hemisphere = p1 * t1 + p2 * t2 + sqrt(max(1.0 - p1 * p1 - p2 * p2, 0.0)) * stretched;
    return normalize(vec3(alpha * hemisphere.xy, max(hemisphere.z, 1e-6)));
}

/// A microfacet normal from the spherical cap above the height -`bound` * stretched.z. Dupuy and Benyoub 2023, "Sampling
/// Visible GGX Normals with Spherical Caps", HPG, listing 3.
vec3 sampleGGXCap(vec3 wo, vec2 u, float alpha, float bound) {
    const vec3 stretched = normalize(vec3(alpha * wo.xy, wo.z));
    const float lowest = bound * stretched.z;
    const float phi = 2.0 * kPi * u.x;
    const float z = (1.0 - u.y) * (1.0 + lowest) - lowest;
    const float sinTheta = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    const vec3 halfway = vec3(sinTheta * cos(phi), sinTheta * sin(phi), z) + stretched;
    return normalize(vec3(alpha * halfway.xy, max(halfway.z, 1e-6)));
}

/// The distribution of sampleGGXVisible: simpler, and the same density for any `u`.
vec3 sampleGGXVisibleCap(vec3 wo, vec2 u, float alpha) {
    return sampleGGXCap(wo, u, alpha, 1.0);
}

/// Fraction of the light on a GGX microfacet visible from `wo` that leaves towards `wi` unhindered: G2 / G1(wo), the
/// weight of a sample of sampleGGXVisible without Fresnel. Heitz 2014, eqs. 43 and 99.
float visibleGGXWeight(float NoV, float NoL, float alpha) {
    const float a2 = alpha * alpha;
    const float lambdaV = sqrt(a2 + (1.0 - a2) * NoV * NoV) / NoV; // 1 + 2 Lambda
    const float lambdaL = sqrt(a2 + (1.0 - a2) * NoL * NoL) / NoL;
    return (1.0 + lambdaV) / (lambdaV + lambdaL);
}

/// The bound of the spherical cap below which no normal reflects upwards. Eto and Tokuyoshi 2023, "Bounded VNDF Sampling
/// for Smith-GGX Reflections", SIGGRAPH Asia, eq. 5.
float reflectedCapBound(float NoV, float alpha) {
    const float a2 = alpha * alpha;
    const float s = 1.0 + sqrt(max(1.0 - NoV * NoV, 0.0));
    return (1.0 - a2) * s * s / (s * s + a2 * NoV * NoV);
}

/// Like sampleGGXVisibleCap, but without most of the normals that reflect below the surface. For reflection alone.
vec3 sampleGGXReflected(vec3 wo, vec2 u, float alpha) {
    return sampleGGXCap(wo, u, alpha, reflectedCapBound(wo.z, alpha));
}

/// Density over solid angle of directions reflected at normals of sampleGGXReflected, as a multiple of D(wm).
float reflectedGGXScale(float NoV, float alpha) {
    const float a2 = alpha * alpha;
    return 0.5 / (reflectedCapBound(NoV, alpha) * NoV + sqrt(a2 + (1.0 - a2) * NoV * NoV));
}

/// D G2 / (4 NoV) over the density of sampleGGXReflected: the weight of its samples, without Fresnel.
float reflectedGGXWeight(float NoV, float NoL, float alpha) {
    const float a2 = alpha * alpha;
    const float lengthV = sqrt(a2 + (1.0 - a2) * NoV * NoV);
    const float ofCap = (reflectedCapBound(NoV, alpha) * NoV + lengthV) / (NoV + lengthV);
    return ofCap * visibleGGXWeight(NoV, NoL, alpha);
}

#endif
