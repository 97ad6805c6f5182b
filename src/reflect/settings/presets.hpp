// The presets that the build embeds into the library (cmake/embed_presets.cmake).
#pragma once

#include <span>
#include <string_view>

namespace glint {

struct EmbeddedPreset {
    std::string_view name; ///< the file's name without .json
    std::string_view json;
};

/// In alphabetical order of the files.
std::span<const EmbeddedPreset> embeddedPresets();

} // namespace glint
