// Meshes and their primitives: attributes, indices, morph targets.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Needs Scene::materials, which decide where tangents are wanted.
void readMeshes(Document& document, Scene& scene);

} // namespace glint::scene::gltf
