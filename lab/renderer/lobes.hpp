// What the opaque surfaces of a scene reflect besides F0 and roughness.
#pragma once

#include "lab/renderer/gbuffer.hpp"
#include "lab/scene/scene.hpp"

namespace glint::render {

/// True if its F90 may be neither that of metals and common dielectrics, 1, nor without effect.
bool hasOwnF90(const scene::Material& material);
bool hasCoat(const scene::Material& material);

/// Asks for the images that the scene's materials need.
GBufferOptions withLobes(GBufferOptions options, const scene::Scene& scene);

} // namespace glint::render
