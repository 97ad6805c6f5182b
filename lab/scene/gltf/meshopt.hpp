// EXT_meshopt_compression: buffer views packed with meshoptimizer's codecs.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Decompresses `source` as `compression` (the extension's object) describes it. Empty after an error in the file.
std::vector<uint8_t> decompressMeshopt(Document& document, const JsonObject& compression,
                                       std::span<const uint8_t> source, size_t viewIndex);

} // namespace glint::scene::gltf
