// Reads skins: the nodes that are joints, and their inverse bind matrices.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

void readSkins(Document& document, Scene& scene, size_t nodeCount);

/// Checks that every joint that a skinned mesh names is in the skin of each node that draws the mesh.
void checkJoints(Document& document, const Scene& scene);

} // namespace glint::scene::gltf
