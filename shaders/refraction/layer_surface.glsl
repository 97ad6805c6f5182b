// The surface of a transparent layer at a pixel, and the body behind it: the host's, with the user's overrides.
#ifndef GLINT_REFRACTION_LAYER_SURFACE_GLSL
#define GLINT_REFRACTION_LAYER_SURFACE_GLSL

#include "lib/brdf.glsl"
#include "lib/host_surface.glsl"
#include "lib/refraction.glsl"
#include "lib/sanitize.glsl"
#include "refraction/layer_inputs.glsl"

/// The host's layer at the pixel, with the user's overrides.
struct LayerSurface {
    HostSurface here;
    vec3 positionVS;
    vec3 toEyeVS;
    uint model;
    float ior;
    float thickness;
    vec3 attenuationColor;
    float attenuationDistance;
    float dispersion;
    vec3 centerWS;
};

void loadSurface(ivec2 px, float z, inout LayerSurface s) {
    s.here.viewZ = z;
    s.here.normalVS = hostNormalVS(frame.constants, texelFetch(layerNormal, px, 0).xyz);
    vec4 material = texelFetch(layerMaterial, px, 0);
    s.here.f0 = clamp(sanitize(material.rgb), 0.0, 1.0);
    s.here.perceptualRoughness = clamp(sanitize(material.a), 0.0, 1.0);
    s.positionVS = viewPosition(frame.constants, (vec2(px) + 0.5) * frame.constants.invSize, z);
    s.toEyeVS = -viewDirection(frame.constants, s.positionVS);
    s.here.normalVS = facingNormal(s.here.normalVS, s.toEyeVS);
    s.centerWS = (frame.constants.viewToWorld * vec4(s.positionVS, 1.0)).xyz;
    if (layerHas(kLayerCenters))
        s.centerWS = texelFetch(layerCenter, px, 0).xyz;
}

void loadBody(ivec2 px, inout LayerSurface s) {
    vec4 stored = texelFetch(layerBody, px, 0);
    vec3 body = sanitize(stored.xyz);
    uint asked = refraction.flags & kLayerModelMask;
    s.model = asked != 0u ? asked - 1u : min(uint(body.z + 0.5), kRefractionThin);
    s.ior = body.x;
    s.dispersion = refraction.dispersion >= 0.0 ? refraction.dispersion : sanitize(stored.w);
    if (refraction.ior > 0.0 && maxComponent(texelFetch(layerTransmittance, px, 0).rgb) > 0.0) {
        // reflectance follows the overriding index
        s.ior = refraction.ior;
        s.here.f0 = vec3(dielectricF0(s.ior));
    }
    s.thickness = (refraction.thickness >= 0.0 ? refraction.thickness : body.y) * refraction.thicknessMultiplier;
}

void loadAbsorption(ivec2 px, inout LayerSurface s) {
    vec4 absorption = texelFetch(layerAbsorption, px, 0);
    vec3 override = vec3(unpackHalf2x16(refraction.transmittance.x), unpackHalf2x16(refraction.transmittance.y).x);
    s.attenuationColor = mix(clamp(sanitize(absorption.rgb), 0.0, 1.0), override, greaterThanEqual(override, vec3(0.0)));
    s.attenuationDistance =
        refraction.absorptionDistance >= 0.0 ? refraction.absorptionDistance : sanitize(absorption.a);
}

/// `z`: of seenLayerZ.
LayerSurface loadLayer(ivec2 px, float z) {
    LayerSurface s;
    loadSurface(px, z, s);
    loadBody(px, s);
    loadAbsorption(px, s);
    return s;
}

/// Fraction of reflected light that the surface sends to the eye. The rest is transmitted.
vec3 surfaceResponse(LayerSurface s) {
    if (frame.settings.composite.fresnel == 0u)
        return s.here.f0;
    float NoV = clamp(dot(s.here.normalVS, s.toEyeVS), 1e-3, 1.0);
    float f90 = edgeReflectance(maxComponent(s.here.f0));
    return specularResponse(s.here.f0, f90, dfgAt(dfg, NoV, s.here.perceptualRoughness));
}

#endif
