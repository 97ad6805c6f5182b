// An opaque or masked surface, lit, and the G-buffer that reflections start from (src/render/gbuffer.hpp).
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/octahedral.glsl"
#include "render/surface_bindings.glsl"

/// A discard in the code costs early depth tests, so fully opaque surfaces are drawn without.
layout(constant_id = 0) const bool kAlphaTest = false;

layout(location = 0) out vec2 outNormal;
layout(location = 1) out vec4 outMaterial;
layout(location = 2) out vec2 outMotion;
layout(location = 3) out vec4 outLitRadiance;
layout(location = 4) out vec4 outFallbackSpecular;
layout(location = 5) out vec4 outAlbedo;

vec2 clipToUV(vec4 positionCS) {
    return positionCS.xy / positionCS.w * vec2(0.5, -0.5) + 0.5;
}

void main() {
    Material material = drawnMaterial();
    SurfacePoint point = interpolatedPoint();
    if (kAlphaTest && sampleBaseColor(material, point).a < material.alphaCutoff)
        discard;
    MaterialSample surface = sampleMaterial(material, point);
    Lighting lighting = lightSurface(surface, point, viewVector());

    outNormal = encodeOctahedral(surface.normalWS);
    outMaterial = vec4(lighting.baseF0, surface.perceptualRoughness);
    outMotion = (clipToUV(previousCS) - view.constants.prevJitterUV) - (clipToUV(currentCS) - view.constants.jitterUV);
    // Half floats end at 65504: an infinity would spread through every blur that comes after.
    outLitRadiance = vec4(min(totalRadiance(lighting), vec3(65000.0)), 1.0);
    outFallbackSpecular = vec4(min(lighting.environmentSpecular, vec3(65000.0)), 1.0);
    outAlbedo = vec4(surface.baseColor, 1.0);
}
