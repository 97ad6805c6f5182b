// A blended or light-transmitting surface over the frame so far. Premultiplied: the reflection in a pane of glass does
// not fade with the pane.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/transmission.glsl"
#include "render/transparent_surface.glsl"

layout(set = 0, binding = 10) uniform sampler2D behind; // the frame without transparent surfaces, with mips

layout(location = 0) out vec4 outRadiance;

/// Transmitted radiance: the frame behind, sampled where the refracted light leaves the volume, blurred by roughness.
vec3 transmittedRadiance(TransparentSurface s) {
    Material material = s.material;
    MaterialSample surface = s.surface;
    vec3 path = refractedPath(surface.normalWS, s.V, material.ior, s.thickness);
    vec4 exitCS = view.constants.worldToClip * vec4(positionWS + path, 1.0);
    vec2 exitUV = exitCS.xy / exitCS.w * vec2(0.5, -0.5) + 0.5;
    float mip =
        log2(float(textureSize(behind, 0).x)) * transmissionRoughness(surface.perceptualRoughness, material.ior);
    vec3 transmittance = volumeTransmittance(length(path), material.attenuationColor, material.attenuationDistance);
    vec2 dfg = loadDfg(clampedNoV(surface.normalWS, s.V), surface.perceptualRoughness);
    vec3 reflected = specularResponse(surface.dielectricF0, surface.dielectricF90, dfg);
    return textureLod(behind, exitUV, mip).rgb * transmittance * surface.baseColor *
           (surface.transmission * (1.0 - saturate(maxComponent(reflected))));
}

void main() {
    TransparentSurface s = transparentSurface();
    vec3 body = s.lighting.diffuse + s.lighting.emission;
    if (s.surface.transmission > 0.0)
        body += transmittedRadiance(s);
    vec3 radiance = body * s.surface.opacity + s.mirrored * s.present;
    outRadiance = vec4(min(radiance, vec3(65000.0)), s.surface.opacity);
}
