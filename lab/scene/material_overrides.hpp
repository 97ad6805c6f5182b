// Changes of a scene's materials that a user makes beside the scene's file: in SCENE.materials.json or in the viewer.
#pragma once

#include "base/result.hpp"
#include "lab/scene/material_fields.hpp"

#include <map>
#include <string>
#include <vector>

namespace glint::scene {

/// An image file in place of a texture, or no texture.
struct TextureOverride {
    std::string file; ///< empty: the texture is removed
    int texture = -1; ///< index into Scene::textures once loadTextures has read the file
};

/// The changes of one material; what is absent stays as in the scene's file.
struct MaterialOverride {
    std::optional<MaterialKind> kind;
    std::map<size_t, FieldValue> values;        ///< by index into materialFields()
    std::map<size_t, TextureOverride> textures; ///< by index into materialTextures()

    bool empty() const { return !kind && values.empty() && textures.empty(); }
};

/// By index into Scene::materials.
using MaterialOverrides = std::map<size_t, MaterialOverride>;

/// Reads overrides for the materials of `scene`: docs/materials.md describes the file. Errors: NotFound for the file;
/// InvalidInput with file, material and field.
Result<MaterialOverrides> readMaterialFile(const std::string& path, const Scene& scene);

/// Returns the key of a material in the file: its name, or "#3" if it shares its name or has none.
std::string materialKey(std::span<const Material> materials, size_t index);

/// Returns the file's text. Texture paths are written relative to the folder of `path`.
std::string materialFileText(const std::string& path, std::span<const Material> materials,
                             const MaterialOverrides& overrides);

/// Appends the textures of the overrides to the scene. Errors: those of readFile and decodeImage.
Result<void> loadTextures(MaterialOverrides& overrides, Scene& scene);

/// Returns the kind of a material after the override.
MaterialKind kindOf(const Material& material, const MaterialOverride& override);

/// Returns a copy of the material with the override; its textures must be loaded. Fields and textures that the
/// resulting kind does not have are ignored.
Material overridden(const Material& material, const MaterialOverride& override);

} // namespace glint::scene
