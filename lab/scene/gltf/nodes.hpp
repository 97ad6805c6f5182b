// Reads the node tree with its cameras, lights, skins and instances, and the scenes.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Requires Scene::meshes. Afterwards the tree is valid: one parent per node, no cycles, scene roots are roots.
void readNodes(Document& document, Scene& scene);

} // namespace glint::scene::gltf
