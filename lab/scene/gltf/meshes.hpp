// Reads meshes and their primitives: attributes, indices, morph targets.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Requires Scene::materials, which determine where tangents are needed.
void readMeshes(Document& document, Scene& scene);

} // namespace glint::scene::gltf
