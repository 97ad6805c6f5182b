// Cameras and KHR_lights_punctual.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

void readCameras(Document& document, Scene& scene);
void readLights(Document& document, Scene& scene);

} // namespace glint::scene::gltf
