#include "lab/scene/material_fields.hpp"

#include <cmath>

namespace glint::scene {
namespace {

constexpr uint32_t kMetal = kindBit(MaterialKind::MetallicRoughness);
constexpr uint32_t kGlossy = kindBit(MaterialKind::SpecularGlossiness);
constexpr uint32_t kStandard = kindBit(MaterialKind::Standard);
constexpr uint32_t kAny = kMetal | kGlossy | kStandard;

constexpr float kBrightest = 1e9f;  ///< radiance
constexpr float kFarthest = 1e9f;   ///< metres
constexpr float kLargestIor = 100;  ///< far above every dielectric
constexpr float kLargestTint = 1e3; ///< KHR_materials_specular allows colours above 1

constexpr std::string_view kShapes[] = {"byShape", "none", "sphere", "plane", "thin"}; // as RefractionShape

template <float Material::*member>
FieldValue number(const Material& m) {
    return FieldValue(m.*member);
}
template <float Material::*member>
void setNumber(Material& m, FieldValue value) {
    m.*member = value.x;
}
template <glm::vec3 Material::*member>
FieldValue color(const Material& m) {
    return m.*member;
}
template <glm::vec3 Material::*member>
void setColor(Material& m, FieldValue value) {
    m.*member = value;
}

template <float Material::*member>
MaterialField numberField(std::string_view name, uint32_t kinds, float min, float max, std::string_view meaning) {
    return {name, kinds, FieldType::Number, min, max, meaning, number<member>, setNumber<member>};
}
template <glm::vec3 Material::*member>
MaterialField colorField(std::string_view name, uint32_t kinds, float max, std::string_view meaning) {
    return {name, kinds, FieldType::Color, 0, max, meaning, color<member>, setColor<member>};
}

MaterialField baseColorField() {
    return {"baseColor",
            kAny,
            FieldType::Color,
            0,
            1,
            "colour, linear; multiplies its texture",
            [](const Material& m) { return FieldValue(m.baseColorFactor); },
            [](Material& m, FieldValue v) { m.baseColorFactor = glm::vec4(v, m.baseColorFactor.w); }};
}

MaterialField opacityField() {
    return {"opacity",
            kAny,
            FieldType::Number,
            0,
            1,
            "of masked and blended materials; multiplies the base colour texture's alpha",
            [](const Material& m) { return FieldValue(m.baseColorFactor.w); },
            [](Material& m, FieldValue v) { m.baseColorFactor.w = v.x; }};
}

MaterialField emissionStrengthField() {
    return {"emissionStrength",
            kAny,
            FieldType::Number,
            0,
            kBrightest,
            "multiplies `emission`, or the emission of the scene's file",
            [](const Material&) { return FieldValue(1); },
            [](Material& m, FieldValue v) { m.emissiveFactor *= v.x; }};
}

MaterialField attenuationDistanceField() {
    return {
        "attenuationDistance",
        kMetal,
        FieldType::Number,
        0,
        kFarthest,
        "metres after which white light has the attenuation colour; 0: no absorption",
        [](const Material& m) { return FieldValue(std::isfinite(m.attenuationDistance) ? m.attenuationDistance : 0); },
        [](Material& m, FieldValue v) {
            m.attenuationDistance = v.x > 0 ? v.x : std::numeric_limits<float>::infinity();
        }};
}

MaterialField refractionField() {
    return {"refraction",
            kMetal,
            FieldType::Choice,
            0,
            0,
            "shape that refraction assumes for the body",
            [](const Material& m) { return FieldValue(static_cast<float>(m.refraction)); },
            [](Material& m, FieldValue v) { m.refraction = static_cast<RefractionShape>(v.x); },
            kShapes};
}

MaterialField planarField() {
    return {"planar",
            kAny,
            FieldType::Switch,
            0,
            0,
            "true: flat surfaces are planar mirrors, with --planar named or auto; false: they never are",
            [](const Material& m) { return FieldValue(m.planarMirror.value_or(false)); },
            [](Material& m, FieldValue v) { m.planarMirror = v.x != 0; }};
}

MaterialField doubleSidedField() {
    return {"doubleSided",
            kAny,
            FieldType::Switch,
            0,
            0,
            "draw both sides",
            [](const Material& m) { return FieldValue(m.doubleSided); },
            [](Material& m, FieldValue v) { m.doubleSided = v.x != 0; }};
}

} // namespace

std::span<const MaterialField> materialFields() {
    using M = Material;
    static const MaterialField fields[] = {
        baseColorField(),
        opacityField(),
        numberField<&M::metallicFactor>("metallic", kMetal, 0, 1, "0 dielectric, 1 metal; multiplies its texture"),
        numberField<&M::roughnessFactor>("roughness", kMetal, 0, 1, "perceptual roughness; multiplies its texture"),
        numberField<&M::specularFactor>("specular", kMetal, 0, 1, "strength of a dielectric's reflection"),
        colorField<&M::specularColorFactor>("specularColor", kMetal, kLargestTint, "F0 tint of a dielectric"),
        colorField<&M::specularGlossinessFactor>("specularColor", kGlossy | kStandard, 1, "F0; multiplies its texture"),
        numberField<&M::glossinessFactor>("glossiness", kGlossy, 0, 1, "1 - roughness; multiplies its texture"),
        colorField<&M::emissiveFactor>("emission", kAny, kBrightest, "radiance; multiplies its texture"),
        emissionStrengthField(),
        numberField<&M::normalScale>("normalScale", kAny, -100, 100, "multiplies the normal map's slopes"),
        numberField<&M::occlusionStrength>("occlusionStrength", kAny, 0, 1, "of the occlusion texture"),
        numberField<&M::clearcoatFactor>("clearcoat", kAny, 0, 1, "strength of a clear layer on top"),
        numberField<&M::clearcoatRoughnessFactor>("clearcoatRoughness", kAny, 0, 1, "of that layer"),
        numberField<&M::ior>("ior", kMetal, 1, kLargestIor, "index of refraction; sets a dielectric's F0"),
        numberField<&M::transmissionFactor>("transmission", kMetal, 0, 1, "share of light that enters the body"),
        numberField<&M::thicknessFactor>("thickness", kMetal, 0, kFarthest, "of the body, metres in the mesh's space"),
        colorField<&M::attenuationColor>("attenuationColor", kMetal, 1, "colour of white light after the distance"),
        attenuationDistanceField(),
        numberField<&M::dispersion>("dispersion", kMetal, 0, 100, "20 / Abbe number; 0: none"),
        refractionField(),
        planarField(),
        doubleSidedField(),
    };
    return fields;
}

// Normal maps are missing: the scene's reader computes tangents only for surfaces whose own material has one.
std::span<const MaterialTexture> materialTextures() {
    using M = Material;
    static const MaterialTexture textures[] = {
        {"baseColor", kAny, &M::baseColorTexture, "rgb sRGB, alpha opacity"},
        {"metallicRoughness", kMetal, &M::metallicRoughnessTexture, "green roughness, blue metallic"},
        {"specular", kMetal, &M::specularTexture, "alpha strength"},
        {"specularColor", kMetal, &M::specularColorTexture, "rgb sRGB"},
        {"specularColor", kStandard, &M::specularGlossinessTexture, "rgb sRGB; alpha is ignored"},
        {"specularGlossiness", kGlossy, &M::specularGlossinessTexture, "rgb sRGB, alpha glossiness"},
        {"emission", kAny, &M::emissiveTexture, "rgb sRGB"},
        {"occlusion", kAny, &M::occlusionTexture, "red"},
        {"transmission", kMetal, &M::transmissionTexture, "red"},
        {"thickness", kMetal, &M::thicknessTexture, "green"},
        {"clearcoat", kAny, &M::clearcoatTexture, "red"},
        {"clearcoatRoughness", kAny, &M::clearcoatRoughnessTexture, "green"},
    };
    return textures;
}

MaterialKind kindOf(const Material& material) {
    return material.specularGlossiness ? MaterialKind::SpecularGlossiness : MaterialKind::MetallicRoughness;
}

void setKind(Material& material, MaterialKind kind) {
    material.specularGlossiness = kind != MaterialKind::MetallicRoughness;
    if (kind != MaterialKind::Standard)
        return;
    material.specularGlossinessFactor = glm::vec3(1);
    material.glossinessFactor = 1;
    material.specularGlossinessTexture = {};
}

} // namespace glint::scene
