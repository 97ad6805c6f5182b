// Which extensions this reader knows, and what happens to files that ask for others.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Checks asset.version, refuses required extensions that are not read (ErrorCode::Unsupported) and warns once about
/// optional ones.
void checkVersionAndExtensions(Document& document);

} // namespace glint::scene::gltf
