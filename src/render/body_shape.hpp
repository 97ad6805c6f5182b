// What a thing that transmits light is taken for by refraction: glint/transparent_layer.hpp.
#pragma once

#include "glint/transparent_layer.hpp"
#include "scene/scene.hpp"

namespace glint::render {

/// As the material says (extras.glint.refraction). Else by its shape, for the thing as a whole, so that no seam runs
/// across it: a sphere if it is curved at least a fifth as much as a ball of its thickness, else a plate. Straight for
/// what transmits no light or has no thickness. Cost: it looks at every triangle of what has one.
BodyShape bodyShape(const scene::Material& material, const scene::Geometry& geometry);

} // namespace glint::render
