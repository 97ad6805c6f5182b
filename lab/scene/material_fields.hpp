// The fields of a material that a user may override (lab/scene/material_overrides.hpp): one table for the file's reader
// and writer and for the viewer's panel. docs/materials.md describes the same fields; a test compares the names.
#pragma once

#include "lab/scene/scene.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace glint::scene {

enum class MaterialKind : uint8_t {
    MetallicRoughness,
    SpecularGlossiness,
    Standard, ///< sharp; a specular colour alone (glint/gbuffer.hpp)
};

/// The file's names, in the order of MaterialKind.
inline constexpr std::string_view kMaterialKindNames[] = {"metallicRoughness", "specularGlossiness", "standard"};

/// Kinds of materials as a set of bits.
constexpr uint32_t kindBit(MaterialKind kind) {
    return 1u << static_cast<uint32_t>(kind);
}

enum class FieldType : uint8_t { Number, Color, Switch, Choice };

/// A value of any FieldType: a number or a switch in x, a colour in xyz, the index of a choice in x.
using FieldValue = glm::vec3;

struct MaterialField {
    std::string_view name;
    uint32_t kinds = 0; ///< the kinds of materials that have the field
    FieldType type = FieldType::Number;
    float min = 0; ///< of a number, or of each part of a colour
    float max = 1;
    std::string_view meaning; ///< one line, with the unit
    FieldValue (*get)(const Material&) = nullptr;
    void (*set)(Material&, FieldValue) = nullptr;
    std::span<const std::string_view> choices = {};
};

/// Every field, in the order in which fields are set. A name may occur twice, for different kinds.
std::span<const MaterialField> materialFields();

/// A texture that a user may replace or remove.
struct MaterialTexture {
    std::string_view name;
    uint32_t kinds = 0;
    TextureSlot Material::*slot = nullptr;
    std::string_view meaning; ///< the channels that are read
};

std::span<const MaterialTexture> materialTextures();

/// The kind as the scene's file declares it; never Standard, which glTF does not have.
MaterialKind kindOf(const Material& material);

/// Changes the kind. A Standard material starts with a white specular colour without a texture.
void setKind(Material& material, MaterialKind kind);

} // namespace glint::scene
