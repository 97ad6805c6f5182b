// The split-sum integral. Karis 2013, "Real Shading in Unreal Engine 4": a GGX lobe reflects f0 * x + f90 * y of
// uniform light.
#ifndef GLINT_LIB_DFG_GLSL
#define GLINT_LIB_DFG_GLSL

#include "lib/brdf.glsl"
#include "lib/sampling.glsl"

/// By sampling visible normals the estimator is F * G2 / G1(wo), which has little variance: 256 samples are within
/// 0.005 of the integral. `NoV` in (0, 1], roughness in [0, 1].
vec2 integrateDfg(float NoV, float perceptualRoughness) {
    const uint kSamples = 256u;
    const float alpha = max(perceptualRoughness * perceptualRoughness, 1e-4);
    const vec3 wo = vec3(sqrt(max(1.0 - NoV * NoV, 0.0)), 0.0, NoV);
    // Smith's G1(wo) from the same lambda that the height-correlated G2 uses.
    const float a2 = alpha * alpha;
    const float g1 = 2.0 * NoV / (NoV + sqrt(a2 + (1.0 - a2) * NoV * NoV));
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < kSamples; ++i) {
        const vec3 wm = sampleGGXVisible(wo, hammersley(i, kSamples), alpha);
        const vec3 wi = reflect(-wo, wm);
        if (wi.z <= 0.0)
            continue;
        const float g2 = 4.0 * wi.z * NoV * V_SmithGGXCorrelated(NoV, wi.z, alpha);
        const float fresnel = pow5(1.0 - max(dot(wo, wm), 0.0));
        sum += vec2(1.0 - fresnel, fresnel) * g2 / g1;
    }
    return sum / float(kSamples);
}

#endif
