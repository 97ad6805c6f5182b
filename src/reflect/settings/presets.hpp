// The presets as the build puts them into the library (cmake/embed_presets.cmake).
#pragma once

#include <span>
#include <string_view>

namespace glint {

struct EmbeddedPreset {
    std::string_view name; ///< the file's, without .json
    std::string_view json;
};

/// In the files' alphabetical order.
std::span<const EmbeddedPreset> embeddedPresets();

} // namespace glint
