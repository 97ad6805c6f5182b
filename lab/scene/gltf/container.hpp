// The two containers of glTF: JSON text, and the binary container (.glb) of a JSON chunk and one optional buffer. Based
// on: glTF 2.0 specification, section 4, "GLB File Format Specification".
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace glint::scene::gltf {

/// Views into the given bytes, which must outlive it.
struct Container {
    std::span<const uint8_t> json;
    std::optional<std::span<const uint8_t>> binary; ///< the BIN chunk
};

/// Distinguishes the two by content, never by name. Errors: InvalidInput (empty, truncated, neither format).
Result<Container> openContainer(std::span<const uint8_t> bytes, const std::string& fileName);

} // namespace glint::scene::gltf
