// Loads buffers (files, data URIs, the binary chunk) and the views into them.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Loads every buffer and checks every view against its buffer; compressed views are decompressed.
void readBuffers(Document& document);

} // namespace glint::scene::gltf
