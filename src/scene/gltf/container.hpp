// The two wrappings of glTF: JSON text, and the binary container (.glb) of a JSON chunk and one optional buffer.
// Based on: glTF 2.0 specification, section 4, "GLB File Format Specification".
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace glint::scene::gltf {

/// Parts of the bytes that were given, which must stay alive.
struct Container {
    std::span<const uint8_t> json;
    std::optional<std::span<const uint8_t>> binary; ///< the BIN chunk
};

/// Tells the two apart by content, never by name. Errors: InvalidInput (empty, truncated, neither of both).
Result<Container> openContainer(std::span<const uint8_t> bytes, const std::string& fileName);

} // namespace glint::scene::gltf
