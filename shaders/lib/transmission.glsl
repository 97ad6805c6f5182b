// Light that passes through a surface (KHR_materials_transmission, KHR_materials_volume), sampled from an image of what
// is behind it. The light refracts once, on entering; where it leaves is estimated from the thickness.
#ifndef GLINT_LIB_TRANSMISSION_GLSL
#define GLINT_LIB_TRANSMISSION_GLSL

#include "lib/math.glsl"

/// Offset from the surface to where the light leaves the volume, world space. Thin walls (thickness 0) do not bend
/// light.
vec3 refractedPath(vec3 N, vec3 V, float ior, float thicknessWS) {
    if (thicknessWS <= 0.0 || ior <= 0.0)
        return vec3(0.0);
    return normalizeOr(refract(-V, N, 1.0 / max(ior, 1.0)), -V) * thicknessWS;
}

/// Roughness blurs less where the ratio of refraction is near 1: Khronos' glTF Sample Viewer, applyIorToRoughness.
float transmissionRoughness(float perceptualRoughness, float ior) {
    return perceptualRoughness * saturate(ior * 2.0 - 2.0);
}

/// Beer-Lambert: `attenuationColor` is the transmittance after `attenuationDistance` metres; distance 0: no absorption.
vec3 volumeTransmittance(float pathLength, vec3 attenuationColor, float attenuationDistance) {
    if (attenuationDistance <= 0.0)
        return vec3(1.0);
    return pow(max(attenuationColor, vec3(1e-6)), vec3(pathLength / attenuationDistance));
}

#endif
