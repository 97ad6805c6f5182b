// From a "uri" property to bytes.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// The bytes behind `uri`, a property of `owner`: decoded from a data URI or asked of the document's resolver.
/// Empty after a mistake.
std::vector<uint8_t> loadUri(Document& document, const JsonObject& owner, const std::string& uri);

} // namespace glint::scene::gltf
