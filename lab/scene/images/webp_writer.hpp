// Encodes WebP: smaller than PNG, and every browser shows it.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace glint::scene {

/// `rgb`      width * height * 3, rows from the top; a side has at most 16383 pixels
/// `quality`  [0, 100], with loss; absent: without
/// Returns the bytes of the file. The same pixels make the same bytes with one version of the library. Errors:
/// InvalidArgument for a side that WebP cannot store; OutOfMemory.
Result<std::string> encodeWebp(uint32_t width, uint32_t height, std::span<const uint8_t> rgb,
                               std::optional<float> quality = {});

} // namespace glint::scene
