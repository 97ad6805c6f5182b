// A glTF material at one point: converts textures and factors to the inputs of the lighting functions. Rasterized and
// ray-traced surfaces call the same code; the entry point defines how a texture is sampled.
#ifndef GLINT_LIB_MATERIAL_GLSL
#define GLINT_LIB_MATERIAL_GLSL

#include "lib/brdf.glsl"
#include "shared/material.h"

/// Defined by the entry point. Samples the texture table's entry `ref.index`, filtered, at `uv`, which is already
/// transformed.
vec4 sampleTexture(TextureRef ref, vec2 uv);

/// A point of a surface, interpolated from its geometry.
struct SurfacePoint {
    vec3 positionWS;
    vec3 normalWS;  // any length; towards the front
    vec4 tangentWS; // xyz any length, w = handedness; zero: none
    vec2 uv0;
    vec2 uv1;
    vec4 color; // linear, multiplies the base colour
    bool frontFacing;
};

/// The base lobe is one GGX lobe for metal and dielectric together, because their Fresnel terms mix linearly.
struct MaterialSample {
    vec3 baseColor;    // linear, for debug views and unlit surfaces
    float opacity;     // [0, 1]
    vec3 emission;     // radiance
    vec3 diffuseColor; // albedo of the diffuse lobe, before the specular lobe takes its share
    vec3 f0;
    float f90;
    vec3 dielectricF0; // the diffuse lobe's loss to reflection excludes metal
    float dielectricF90;
    float perceptualRoughness;
    float occlusion; // [0, 1], of indirect light
    vec3 normalWS;   // unit, faces the viewer's side of the surface
    vec3 geometricNormalWS;
    float clearcoat; // [0, 1]
    float clearcoatPerceptualRoughness;
    vec3 clearcoatNormalWS;
    float transmission; // [0, 1], of light that enters instead of scattering
    float thickness;    // metres in the mesh's space
};

vec2 transformUV(TextureRef ref, SurfacePoint point) {
    vec3 uv = vec3(ref.texCoord == 0u ? point.uv0 : point.uv1, 1.0);
    return vec2(dot(ref.uvRow0, uv), dot(ref.uvRow1, uv));
}

/// White where the material has no texture in the slot.
vec4 sampleSlot(TextureRef ref, SurfacePoint point) {
    return ref.index == kNoTexture ? vec4(1.0) : sampleTexture(ref, transformUV(ref, point));
}

/// The base colour alone, which alpha tests need.
vec4 sampleBaseColor(Material material, SurfacePoint point) {
    return material.baseColorFactor * sampleSlot(material.baseColorTexture, point) * point.color;
}

/// Tangent-space normal map -> world space, unit (glTF 2.0, section 3.9.3).
vec3 sampleNormal(TextureRef ref, float scale, SurfacePoint point, vec3 normalWS) {
    if (ref.index == kNoTexture || point.tangentWS.w == 0.0)
        return normalWS;
    vec3 normalTS = sampleTexture(ref, transformUV(ref, point)).xyz * 2.0 - 1.0;
    normalTS.xy *= scale;
    // Interpolation skews the frame: orthogonalize the tangent; the bitangent then follows as the exporter made it.
    vec3 tangentWS = normalizeOr(point.tangentWS.xyz - normalWS * dot(normalWS, point.tangentWS.xyz), vec3(0.0));
    vec3 bitangentWS = cross(normalWS, tangentWS) * point.tangentWS.w;
    return normalizeOr(mat3(tangentWS, bitangentWS, normalWS) * normalTS, normalWS);
}

void applyMetallicRoughness(inout MaterialSample result, Material material, SurfacePoint point) {
    vec4 metallicRoughness = sampleSlot(material.metallicRoughnessTexture, point);
    float metallic = saturate(material.metallicFactor * metallicRoughness.b);
    result.perceptualRoughness = saturate(material.roughnessFactor * metallicRoughness.g);
    // KHR_materials_specular and KHR_materials_ior
    float specular = material.specularFactor * sampleSlot(material.specularTexture, point).a;
    vec3 specularColor = material.specularColorFactor * sampleSlot(material.specularColorTexture, point).rgb;
    result.dielectricF0 = min(dielectricF0(material.ior) * specularColor, vec3(1.0)) * specular;
    result.dielectricF90 = specular * edgeReflectance(dielectricF0(material.ior));
    result.f0 = mix(result.dielectricF0, result.baseColor, metallic);
    result.f90 = mix(result.dielectricF90, 1.0, metallic);
    result.transmission =
        material.transmissionFactor * sampleSlot(material.transmissionTexture, point).r * (1.0 - metallic);
    result.diffuseColor = result.baseColor * (1.0 - metallic) * (1.0 - result.transmission);
}

/// KHR_materials_pbrSpecularGlossiness: colours are given directly, glossiness is 1 - roughness.
void applySpecularGlossiness(inout MaterialSample result, Material material, SurfacePoint point) {
    vec4 specularGlossiness = sampleSlot(material.specularGlossinessTexture, point);
    result.f0 = result.dielectricF0 = material.specularGlossinessFactor * specularGlossiness.rgb;
    result.f90 = result.dielectricF90 = maxComponent(result.f0) > 0.0 ? 1.0 : 0.0; // black specular reflects no light
    result.perceptualRoughness = saturate(1.0 - material.glossinessFactor * specularGlossiness.a);
    result.diffuseColor = result.baseColor * (1.0 - maxComponent(result.f0));
    result.transmission = 0.0;
}

MaterialSample sampleMaterial(Material material, SurfacePoint point) {
    MaterialSample result;
    vec4 baseColor = sampleBaseColor(material, point);
    result.baseColor = baseColor.rgb;
    // glTF 2.0, 3.9.4: opaque surfaces ignore alpha; a masked surface has used its alpha in the alpha test.
    result.opacity = (material.flags & kMaterialAlphaBlend) != 0u ? saturate(baseColor.a) : 1.0;
    if ((material.flags & kMaterialSpecularGlossiness) != 0u)
        applySpecularGlossiness(result, material, point);
    else
        applyMetallicRoughness(result, material, point);
    result.thickness = material.thicknessFactor * sampleSlot(material.thicknessTexture, point).g;
    result.emission = material.emissiveFactor * sampleSlot(material.emissiveTexture, point).rgb;
    result.occlusion = 1.0;
    if (material.occlusionTexture.index != kNoTexture)
        result.occlusion = 1.0 + material.occlusionStrength * (sampleSlot(material.occlusionTexture, point).r - 1.0);

    // Back faces are lit as if the whole frame, normal map included, were flipped.
    float side = point.frontFacing ? 1.0 : -1.0;
    vec3 normalWS = normalizeOr(point.normalWS, vec3(0.0, 1.0, 0.0));
    result.geometricNormalWS = normalWS * side;
    result.normalWS = sampleNormal(material.normalTexture, material.normalScale, point, normalWS) * side;
    result.clearcoat = material.clearcoatFactor * sampleSlot(material.clearcoatTexture, point).r;
    result.clearcoatPerceptualRoughness =
        saturate(material.clearcoatRoughnessFactor * sampleSlot(material.clearcoatRoughnessTexture, point).g);
    result.clearcoatNormalWS =
        sampleNormal(material.clearcoatNormalTexture, material.clearcoatNormalScale, point, normalWS) * side;

    if ((material.flags & kMaterialUnlit) != 0u) { // the base colour as it is, KHR_materials_unlit
        result.emission = result.baseColor;
        result.diffuseColor = result.f0 = result.dielectricF0 = vec3(0.0);
        result.f90 = result.dielectricF90 = result.clearcoat = result.transmission = 0.0;
        result.perceptualRoughness = 1.0;
    }
    return result;
}

#endif
