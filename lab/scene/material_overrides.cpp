#include "lab/scene/material_overrides.hpp"

#include "base/file.hpp"
#include "lab/scene/images/image_decode.hpp"

#include <utility>

namespace glint::scene {
namespace {

constexpr size_t kLongestImageFile = size_t{1} << 30;

Result<int> loadTexture(const std::string& file, bool ignoreAlpha, Scene& scene) {
    GLINT_TRY(bytes, readFile(file, kLongestImageFile));
    GLINT_TRY(image, decodeImage({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, file));
    if (ignoreAlpha)
        for (size_t i = 3; i < image.rgba.size(); i += 4)
            image.rgba[i] = 255;
    scene.images.push_back(std::move(image));
    scene.textures.push_back({static_cast<int>(scene.images.size()) - 1, {}});
    return static_cast<int>(scene.textures.size()) - 1;
}

/// The renderer stores a Standard material as specular-glossiness, whose texture has glossiness in its alpha.
bool ignoresAlpha(const MaterialTexture& info) {
    return info.kinds == kindBit(MaterialKind::Standard);
}

} // namespace

Result<void> loadTextures(MaterialOverrides& overrides, Scene& scene) {
    std::map<std::pair<std::string, bool>, int> loaded;
    for (auto& [index, override] : overrides)
        for (auto& [slot, choice] : override.textures) {
            if (choice.file.empty() || choice.texture >= 0)
                continue;
            const std::pair key(choice.file, ignoresAlpha(materialTextures()[slot]));
            if (!loaded.contains(key)) {
                GLINT_TRY(texture, loadTexture(key.first, key.second, scene));
                loaded[key] = texture;
            }
            choice.texture = loaded[key];
        }
    return {};
}

MaterialKind kindOf(const Material& material, const MaterialOverride& override) {
    return override.kind.value_or(kindOf(material));
}

Material overridden(const Material& material, const MaterialOverride& override) {
    Material result = material;
    const uint32_t kind = kindBit(kindOf(material, override));
    if (override.kind)
        setKind(result, *override.kind);
    for (const auto& [index, value] : override.values) // in the table's order: emission before emissionStrength
        if (const MaterialField& field = materialFields()[index]; (field.kinds & kind) != 0)
            field.set(result, value);
    for (const auto& [index, choice] : override.textures)
        if (const MaterialTexture& info = materialTextures()[index]; (info.kinds & kind) != 0)
            (result.*info.slot).texture = choice.texture;
    return result;
}

} // namespace glint::scene
