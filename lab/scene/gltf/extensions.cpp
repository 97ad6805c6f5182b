#include "lab/scene/gltf/extensions.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace glint::scene::gltf {
namespace {

constexpr std::array<std::string_view, 19> kSupported = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    // Understood, not decoded: a texture that exists only as KTX2 is drawn white, with a warning (gltf/textures.cpp).
    "KHR_texture_basisu",
    // Metadata only, without effect on the image.
    "KHR_xmp",
    "KHR_xmp_json_ld",
};

bool isSupported(const std::string& name) {
    return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

/// "2.0" -> 2 and 0.
std::optional<std::pair<int, int>> parseVersion(const std::string& text) {
    std::pair<int, int> version;
    const char* end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.first);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.')
        return std::nullopt;
    const auto minor = std::from_chars(major.ptr + 1, end, version.second);
    if (minor.ec != std::errc() || minor.ptr != end)
        return std::nullopt;
    return version;
}

void checkVersion(const JsonObject& root) {
    Diagnostics& diagnostics = root.diagnostics();
    const JsonObject asset = root.object("asset");
    if (!asset.has("version")) {
        diagnostics.fail("asset.version is missing; is this a glTF file?");
        return;
    }
    const std::string version = asset.string("version");
    const auto parsed = parseVersion(version);
    if (!parsed || parsed->first != 2) {
        diagnostics.fail("is glTF version \"{}\"; only 2.x can be read", version);
        return;
    }
    const std::string minVersion = asset.string("minVersion");
    if (!minVersion.empty() && minVersion != "2.0")
        diagnostics.fail("needs a reader of glTF {}; this one knows 2.0", minVersion);
}

} // namespace

void checkVersionAndExtensions(Document& document) {
    const JsonObject root = document.root();
    checkVersion(root);

    const std::vector<std::string> required = root.strings("extensionsRequired");
    for (const std::string& name : required) {
        if (!isSupported(name)) {
            document.diagnostics.fail(makeError(ErrorCode::Unsupported, "{}: requires {}, which Glint does not support",
                                                document.diagnostics.file(), name));
            return;
        }
    }
    std::vector<std::string> ignored;
    for (const std::string& name : root.strings("extensionsUsed"))
        if (!isSupported(name))
            ignored.push_back(name);
    if (!ignored.empty())
        document.diagnostics.warn("ignores {}, which Glint does not support; the model may look different",
                                  fmt::join(ignored, ", "));
}

} // namespace glint::scene::gltf
