#include "lab/renderer/gpu_materials.hpp"

#include <cmath>

namespace glint::render {
namespace {

shared::TextureRef textureRef(const scene::TextureSlot& slot, TextureKind kind, const GpuTextures& textures) {
    const glm::mat3 rows = glm::transpose(slot.uvTransform);
    return {textures.index(slot, kind), slot.texCoord, rows[0], rows[1]};
}

uint32_t materialFlags(const scene::Material& material) {
    uint32_t flags = 0;
    if (material.unlit)
        flags |= shared::kMaterialUnlit;
    if (material.specularGlossiness)
        flags |= shared::kMaterialSpecularGlossiness;
    if (material.alphaMode == scene::AlphaMode::Mask)
        flags |= shared::kMaterialAlphaMask;
    if (material.alphaMode == scene::AlphaMode::Blend)
        flags |= shared::kMaterialAlphaBlend;
    return flags;
}

} // namespace

shared::Material gpuMaterial(const scene::Material& m, const GpuTextures& textures) {
    const auto color = [&](const scene::TextureSlot& slot) { return textureRef(slot, TextureKind::Color, textures); };
    const auto data = [&](const scene::TextureSlot& slot) { return textureRef(slot, TextureKind::Data, textures); };
    shared::Material out = {};
    out.flags = materialFlags(m);
    out.alphaCutoff = m.alphaCutoff;
    out.baseColorFactor = m.baseColorFactor;
    out.metallicFactor = m.metallicFactor;
    out.roughnessFactor = m.roughnessFactor;
    out.emissiveFactor = m.emissiveFactor;
    out.normalScale = m.normalScale;
    out.occlusionStrength = m.occlusionStrength;
    out.specularFactor = m.specularFactor;
    out.specularColorFactor = m.specularColorFactor;
    out.ior = m.ior;
    out.transmissionFactor = m.transmissionFactor;
    out.thicknessFactor = m.thicknessFactor;
    out.attenuationColor = m.attenuationColor;
    out.attenuationDistance = std::isfinite(m.attenuationDistance) ? m.attenuationDistance : 0;
    out.dispersion = m.dispersion;
    out.clearcoatFactor = m.clearcoatFactor;
    out.clearcoatRoughnessFactor = m.clearcoatRoughnessFactor;
    out.clearcoatNormalScale = m.clearcoatNormalScale;
    out.specularGlossinessFactor = m.specularGlossinessFactor;
    out.glossinessFactor = m.glossinessFactor;

    out.baseColorTexture = color(m.baseColorTexture);
    out.metallicRoughnessTexture = data(m.metallicRoughnessTexture);
    out.normalTexture = data(m.normalTexture);
    out.occlusionTexture = data(m.occlusionTexture);
    out.emissiveTexture = color(m.emissiveTexture);
    out.specularTexture = data(m.specularTexture);
    out.specularColorTexture = color(m.specularColorTexture);
    out.transmissionTexture = data(m.transmissionTexture);
    out.thicknessTexture = data(m.thicknessTexture);
    out.clearcoatTexture = data(m.clearcoatTexture);
    out.clearcoatRoughnessTexture = data(m.clearcoatRoughnessTexture);
    out.clearcoatNormalTexture = data(m.clearcoatNormalTexture);
    out.specularGlossinessTexture = color(m.specularGlossinessTexture);
    return out;
}

bool transmitsLight(const scene::Material& material) {
    return material.transmissionFactor > 0 && !material.unlit && !material.specularGlossiness;
}

SurfaceClass surfaceClass(const scene::Material& material) {
    if (material.alphaMode == scene::AlphaMode::Blend || transmitsLight(material))
        return SurfaceClass::Transparent;
    return material.alphaMode == scene::AlphaMode::Mask ? SurfaceClass::Masked : SurfaceClass::Opaque;
}

} // namespace glint::render
