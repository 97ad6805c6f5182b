// The node tree and what hangs on it: cameras, lights, skins, instances, scenes.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Needs Scene::meshes. The tree is sound afterwards: one parent a node, no cycles, scene roots are roots.
void readNodes(Document& document, Scene& scene);

} // namespace glint::scene::gltf
