// A glTF material: the factors of scene::Material and its textures' indices in the texture table.
#ifndef GLINT_SHARED_MATERIAL_H
#define GLINT_SHARED_MATERIAL_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kNoTexture, 0xffffffffu);

/// One use of a texture. uv' = (dot(uvRow0, (uv, 1)), dot(uvRow1, (uv, 1))), KHR_texture_transform.
struct TextureRef {
    uint index;    ///< into the texture table; kNoTexture: the factor alone applies
    uint texCoord; ///< 0 or 1
    float3 uvRow0;
    float3 uvRow1;
};

GLINT_CONSTANT(uint, kMaterialUnlit, 1u);
GLINT_CONSTANT(uint, kMaterialSpecularGlossiness, 2u);
GLINT_CONSTANT(uint, kMaterialAlphaMask, 4u);
GLINT_CONSTANT(uint, kMaterialAlphaBlend, 8u);

/// Names, units and defaults are glTF's (lab/scene/scene.hpp).
struct Material {
    uint flags; ///< kMaterial...
    float alphaCutoff;
    float4 baseColorFactor;
    float metallicFactor;
    float roughnessFactor;
    float3 emissiveFactor;
    float normalScale;
    float occlusionStrength;
    float specularFactor;
    float3 specularColorFactor;
    float ior; ///< 0: infinite
    float transmissionFactor;
    float thicknessFactor; ///< metres in the mesh's space
    float3 attenuationColor;
    float attenuationDistance; ///< metres; 0: no absorption
    float dispersion;          ///< 20 / Abbe number
    float clearcoatFactor;
    float clearcoatRoughnessFactor;
    float clearcoatNormalScale;
    float3 specularGlossinessFactor;
    float glossinessFactor;

    TextureRef baseColorTexture;
    TextureRef metallicRoughnessTexture;
    TextureRef normalTexture;
    TextureRef occlusionTexture;
    TextureRef emissiveTexture;
    TextureRef specularTexture;
    TextureRef specularColorTexture;
    TextureRef transmissionTexture;
    TextureRef thicknessTexture;
    TextureRef clearcoatTexture;
    TextureRef clearcoatRoughnessTexture;
    TextureRef clearcoatNormalTexture;
    TextureRef specularGlossinessTexture;
};

GLINT_SHARED_END

#ifdef __cplusplus
static_assert(sizeof(glint::shared::TextureRef) == 32);
static_assert(sizeof(glint::shared::Material) == 4 * 32 + 13 * 32);
#endif
#endif
