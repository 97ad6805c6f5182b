// Loads the bytes of a "uri" property.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Returns the bytes of `uri`, a property of `owner`: decoded from a data URI or loaded through the document's
/// resolver. Empty after an error in the file.
std::vector<uint8_t> loadUri(Document& document, const JsonObject& owner, const std::string& uri);

} // namespace glint::scene::gltf
