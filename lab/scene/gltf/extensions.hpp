// The extensions that this reader supports, and the handling of files that use others.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Checks asset.version, rejects required extensions that are not supported (ErrorCode::Unsupported) and warns once
/// about optional ones.
void checkVersionAndExtensions(Document& document);

} // namespace glint::scene::gltf
