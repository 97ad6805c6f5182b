// Skins: which nodes are joints, and where they stood when the mesh was bound to them.
#pragma once

#include "scene/gltf/document.hpp"

namespace glint::scene::gltf {

void readSkins(Document& document, Scene& scene, size_t nodeCount);

/// Every joint that a skinned mesh names must be in the skin of each node that draws it.
void checkJoints(Document& document, const Scene& scene);

} // namespace glint::scene::gltf
