// The body shape that refraction assumes for a transmissive object: glint/transparent_layer.hpp.
#pragma once

#include "glint/transparent_layer.hpp"
#include "lab/scene/scene.hpp"

namespace glint::render {

/// Returns the shape that the material declares (extras.glint.refraction). Without a declaration, one shape is chosen
/// for the whole object, so that no seam crosses it: a sphere if the object's curvature is at least a fifth of that of
/// a ball of its thickness, otherwise a plate. Returns straight if the material transmits no light or has no thickness.
/// Cost: visits every triangle of an object with thickness.
BodyShape bodyShape(const scene::Material& material, const scene::Geometry& geometry);

} // namespace glint::render
