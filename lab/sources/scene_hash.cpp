#include "lab/sources/scene_hash.hpp"

#include "base/hash.hpp"

namespace glint::render {
namespace {

void add(Hash& hash, const scene::TextureSlot& slot) {
    hash.value(slot.texture).value(slot.texCoord).value(slot.uvTransform);
}

void add(Hash& hash, const scene::Material& m) {
    hash.value(m.alphaMode).value(m.alphaCutoff).value(m.doubleSided).value(m.unlit);
    hash.value(m.baseColorFactor).value(m.metallicFactor).value(m.roughnessFactor);
    hash.value(m.normalScale).value(m.occlusionStrength).value(m.emissiveFactor);
    hash.value(m.specularFactor).value(m.specularColorFactor).value(m.ior);
    hash.value(m.transmissionFactor).value(m.thicknessFactor).value(m.attenuationColor).value(m.attenuationDistance);
    hash.value(m.clearcoatFactor).value(m.clearcoatRoughnessFactor).value(m.clearcoatNormalScale);
    hash.value(m.refraction); // decides which faces of a body are drawn
    hash.value(m.specularGlossiness).value(m.specularGlossinessFactor).value(m.glossinessFactor);
    for (const scene::TextureSlot* slot :
         {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture, &m.emissiveTexture,
          &m.specularTexture, &m.specularColorTexture, &m.transmissionTexture, &m.thicknessTexture, &m.clearcoatTexture,
          &m.clearcoatRoughnessTexture, &m.clearcoatNormalTexture, &m.specularGlossinessTexture})
        add(hash, *slot);
}

void add(Hash& hash, const scene::Geometry& geometry) {
    hash.value(geometry.topology).list(geometry.positions).list(geometry.normals).list(geometry.tangents);
    for (const auto& uvs : geometry.uvs)
        hash.list(uvs);
    hash.list(geometry.colors).list(geometry.indices);
}

void add(Hash& hash, const scene::PosedLight& light) {
    hash.value(light.light.type).value(light.light.color).value(light.light.intensity).value(light.light.range);
    hash.value(light.light.innerConeAngle).value(light.light.outerConeAngle);
    hash.value(light.positionWS).value(light.directionWS);
}

void add(Hash& hash, const scene::Texture& texture) {
    const scene::Sampler& s = texture.sampler;
    hash.value(texture.image).value(s.magFilter).value(s.minFilter).value(s.mipFilter).value(s.wrapU).value(s.wrapV);
}

} // namespace

uint64_t sceneHash(const scene::Scene& scene, const scene::Pose& pose) {
    Hash hash;
    for (const scene::Image& image : scene.images)
        hash.value(image.width).value(image.height).list(image.rgba);
    for (const scene::Texture& texture : scene.textures)
        add(hash, texture);
    for (const scene::Material& material : scene.materials)
        add(hash, material);
    for (const scene::DrawItem& item : pose.items) {
        hash.value(item.material).value(item.localToWorld);
        add(hash, *item.geometry);
    }
    for (const scene::PosedLight& light : pose.lights)
        add(hash, light);
    return hash.result();
}

uint64_t lightHash(const JobInputs& inputs, const RenderSettings& settings) {
    Hash hash;
    hash.value(inputs.environment).value(settings.environment.strength).value(settings.environment.rotation);
    hash.value(settings.environment.visible);
    if (inputs.environment == EnvironmentKind::Image)
        hash.value(settings.environment.isProbe)
            .value(inputs.environmentImage.width)
            .value(inputs.environmentImage.height)
            .list(inputs.environmentImage.rgb);
    if (inputs.environment == EnvironmentKind::Sky)
        hash.value(settings.analyticSky.elevation)
            .value(settings.analyticSky.azimuth)
            .value(settings.analyticSky.turbidity);
    hash.value(settings.lights.shadows).value(settings.shadows.resolution);
    return hash.result();
}

} // namespace glint::render
