// Reads samplers, textures and the images that they use.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Fills Scene::textures (same indices as in the file) and Scene::images (only those that a texture uses).
void readTextures(Document& document, Scene& scene);

} // namespace glint::scene::gltf
