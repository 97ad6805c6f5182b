// Materials of core glTF and of the extensions that Scene's Material has fields for.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Needs Scene::textures.
void readMaterials(Document& document, Scene& scene);

} // namespace glint::scene::gltf
