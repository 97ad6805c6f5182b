// Decodes PNG, JPEG and WebP from memory to 8-bit RGBA. The format is determined from the content, never from a name or
// MIME type.
#pragma once

#include "base/result.hpp"
#include "lab/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace glint::scene {

/// Decodes `bytes`; 16-bit channels become 8-bit, grey becomes RGB, missing alpha becomes 255. Colour profiles and
/// gamma chunks are ignored, as glTF requires. The size in the header is checked before pixels are allocated.
///
/// `name`       begins every message and becomes Image::name
/// `maxPixels`  maximum pixels of the image; a side has at most 16384
/// Errors: InvalidInput (another format, damaged, too large).
Result<Image> decodeImage(std::span<const uint8_t> bytes, const std::string& name,
                          uint64_t maxPixels = uint64_t(1) << 27);

} // namespace glint::scene
