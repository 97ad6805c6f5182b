// Reads materials of core glTF and of the extensions that have fields in Scene's Material.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Requires Scene::textures.
void readMaterials(Document& document, Scene& scene);

} // namespace glint::scene::gltf
