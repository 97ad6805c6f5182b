// Keyframe animations of nodes and morph weights.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Requires Scene::nodes and Scene::meshes. Channels without a node, or for properties that Glint does not support, are
/// left out. A channel's values always fit its times and its property.
void readAnimations(Document& document, Scene& scene);

} // namespace glint::scene::gltf
