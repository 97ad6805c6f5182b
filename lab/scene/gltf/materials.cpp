#include "lab/scene/gltf/materials.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

/// KHR_texture_transform: scale, then rotation, then translation. The extension's angle is counter-clockwise in the
/// image, where v points down, so clockwise in (u, v). (The matrix in its text rotates the other way; the Khronos test
/// model TextureTransformTest and the Khronos viewer agree with this one.)
glm::mat3 readUvTransform(const JsonObject& transform) {
    const glm::vec2 offset = transform.vector<2>("offset", glm::vec2(0));
    const glm::vec2 scale = transform.vector<2>("scale", glm::vec2(1));
    const float angle = transform.number("rotation", 0);
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    const glm::mat3 translation(1, 0, 0, 0, 1, 0, offset.x, offset.y, 1); // column by column
    const glm::mat3 rotation(c, -s, 0, s, c, 0, 0, 0, 1);
    const glm::mat3 scaling(scale.x, 0, 0, 0, scale.y, 0, 0, 0, 1);
    return translation * rotation * scaling;
}

TextureSlot readSlot(const JsonObject& parent, const char* key, const Scene& scene) {
    TextureSlot slot;
    const JsonObject object = parent.object(key);
    if (!object.exists())
        return slot;
    slot.texture = object.requiredIndex("index", scene.textures.size(), "textures");
    uint64_t texCoord = object.count("texCoord").value_or(0);
    if (const JsonObject transform = object.extension("KHR_texture_transform"); transform.exists()) {
        slot.uvTransform = readUvTransform(transform);
        texCoord = transform.count("texCoord").value_or(texCoord);
    }
    if (texCoord >= kMaxTexCoords) {
        object.diagnostics().warn("{} uses TEXCOORD_{}; Glint reads the first {} sets and uses TEXCOORD_0",
                                  object.path(), texCoord, kMaxTexCoords);
        texCoord = 0;
    }
    slot.texCoord = static_cast<uint32_t>(texCoord);
    return slot;
}

AlphaMode readAlphaMode(const JsonObject& object) {
    const std::string name = object.string("alphaMode");
    if (name == "MASK")
        return AlphaMode::Mask;
    if (name == "BLEND")
        return AlphaMode::Blend;
    if (!name.empty() && name != "OPAQUE")
        object.diagnostics().fail("{} is \"{}\", which is none of OPAQUE, MASK and BLEND", object.pathOf("alphaMode"),
                                  name);
    return AlphaMode::Opaque;
}

RefractionShape readRefraction(const JsonObject& ours) {
    constexpr std::pair<const char*, RefractionShape> kShapes[] = {{"none", RefractionShape::None},
                                                                   {"sphere", RefractionShape::Sphere},
                                                                   {"plane", RefractionShape::Plane},
                                                                   {"thin", RefractionShape::Thin}};
    const std::string name = ours.string("refraction");
    for (const auto& [known, shape] : kShapes)
        if (name == known)
            return shape;
    if (!name.empty())
        ours.diagnostics().fail("{} is \"{}\", which is none of none, sphere, plane and thin",
                                ours.pathOf("refraction"), name);
    return RefractionShape::ByShape;
}

void readCore(const JsonObject& object, const Scene& scene, Material& material) {
    material.name = object.string("name");
    material.alphaMode = readAlphaMode(object);
    material.alphaCutoff = object.number("alphaCutoff", 0.5f, 0);
    material.doubleSided = object.boolean("doubleSided", false);

    const JsonObject pbr = object.object("pbrMetallicRoughness");
    material.baseColorFactor = glm::clamp(pbr.vector<4>("baseColorFactor", glm::vec4(1)), 0.0f, 1.0f);
    material.baseColorTexture = readSlot(pbr, "baseColorTexture", scene);
    material.metallicFactor = pbr.number("metallicFactor", 1, 0, 1);
    material.roughnessFactor = pbr.number("roughnessFactor", 1, 0, 1);
    material.metallicRoughnessTexture = readSlot(pbr, "metallicRoughnessTexture", scene);

    material.normalTexture = readSlot(object, "normalTexture", scene);
    material.normalScale = object.object("normalTexture").number("scale", 1);
    material.occlusionTexture = readSlot(object, "occlusionTexture", scene);
    material.occlusionStrength = object.object("occlusionTexture").number("strength", 1, 0, 1);
    material.emissiveFactor = glm::clamp(object.vector<3>("emissiveFactor", glm::vec3(0)), 0.0f, 1e9f);
    material.emissiveTexture = readSlot(object, "emissiveTexture", scene);
}

void readSpecular(const JsonObject& specular, const Scene& scene, Material& material) {
    material.specularFactor = specular.number("specularFactor", 1, 0, 1);
    material.specularTexture = readSlot(specular, "specularTexture", scene);
    material.specularColorFactor = glm::max(specular.vector<3>("specularColorFactor", glm::vec3(1)), 0.0f);
    material.specularColorTexture = readSlot(specular, "specularColorTexture", scene);
}

/// 0 means infinite; values between 0 and 1 are undefined.
float readIor(const JsonObject& object) {
    const float ior = object.number("ior", 1.5f, 0);
    return ior > 0 ? std::max(ior, 1.0f) : 0.0f;
}

void readTransmission(const JsonObject& transmission, const JsonObject& volume, const Scene& scene,
                      Material& material) {
    material.transmissionFactor = transmission.number("transmissionFactor", 0, 0, 1);
    material.transmissionTexture = readSlot(transmission, "transmissionTexture", scene);
    material.thicknessFactor = volume.number("thicknessFactor", 0, 0);
    material.thicknessTexture = readSlot(volume, "thicknessTexture", scene);
    material.attenuationColor = glm::clamp(volume.vector<3>("attenuationColor", glm::vec3(1)), 0.0f, 1.0f);
    const float distance = volume.number("attenuationDistance", 0, 0);
    material.attenuationDistance =
        distance > 0 ? distance : std::numeric_limits<float>::infinity(); // the schema excludes 0
}

void readClearcoat(const JsonObject& clearcoat, const Scene& scene, Material& material) {
    material.clearcoatFactor = clearcoat.number("clearcoatFactor", 0, 0, 1);
    material.clearcoatTexture = readSlot(clearcoat, "clearcoatTexture", scene);
    material.clearcoatRoughnessFactor = clearcoat.number("clearcoatRoughnessFactor", 0, 0, 1);
    material.clearcoatRoughnessTexture = readSlot(clearcoat, "clearcoatRoughnessTexture", scene);
    material.clearcoatNormalTexture = readSlot(clearcoat, "clearcoatNormalTexture", scene);
    material.clearcoatNormalScale = clearcoat.object("clearcoatNormalTexture").number("scale", 1);
}

void readSpecularGlossiness(const JsonObject& object, const Scene& scene, Material& material) {
    if (!object.exists())
        return;
    material.specularGlossiness = true;
    material.baseColorFactor = glm::clamp(object.vector<4>("diffuseFactor", glm::vec4(1)), 0.0f, 1.0f);
    material.baseColorTexture = readSlot(object, "diffuseTexture", scene);
    material.specularGlossinessFactor = glm::clamp(object.vector<3>("specularFactor", glm::vec3(1)), 0.0f, 1.0f);
    material.glossinessFactor = object.number("glossinessFactor", 1, 0, 1);
    material.specularGlossinessTexture = readSlot(object, "specularGlossinessTexture", scene);
}

} // namespace

void readMaterials(Document& document, Scene& scene) {
    for (const JsonObject& object : document.root().objects("materials")) {
        Material material;
        readCore(object, scene, material);
        material.unlit = object.extension("KHR_materials_unlit").exists();
        material.emissiveFactor *=
            object.extension("KHR_materials_emissive_strength").number("emissiveStrength", 1, 0, 1e9f);
        readSpecular(object.extension("KHR_materials_specular"), scene, material);
        material.ior = readIor(object.extension("KHR_materials_ior"));
        material.dispersion = object.extension("KHR_materials_dispersion").number("dispersion", 0, 0);
        readTransmission(object.extension("KHR_materials_transmission"), object.extension("KHR_materials_volume"),
                         scene, material);
        readClearcoat(object.extension("KHR_materials_clearcoat"), scene, material);
        readSpecularGlossiness(object.extension("KHR_materials_pbrSpecularGlossiness"), scene, material);
        const JsonObject ours = object.extras("glint");
        if (ours.has("planar"))
            material.planarMirror = ours.boolean("planar", false);
        material.refraction = readRefraction(ours);
        scene.materials.push_back(std::move(material));
    }
}

} // namespace glint::scene::gltf
