// Morph targets and skins: vertices moved on the CPU, once a pose.
// Based on: glTF 2.0 specification, sections 3.7.2.2, "Morph Targets", and 3.7.3, "Skins".
#pragma once

#include "scene/scene.hpp"

#include <span>

namespace glint::scene {

/// Adds the weighted differences of `primitive`'s targets to `geometry`, a copy of the primitive's own. Normals and
/// tangents stay unit and across each other; flat normals are made anew from the moved vertices. Tangents that the
/// reader made are carried along rather than made anew for every pose, which the specification merely recommends.
///
/// `weights`    one a target
void morph(const Primitive& primitive, std::span<const float> weights, Geometry& geometry);

/// Moves every vertex by the weighted sum of its joints' matrices. Where that sum mirrors, triangles are turned round
/// and tangents change hands, so that fronts stay fronts: a skinned draw has no matrix whose determinant could tell.
///
/// `skinToWorld`    one a joint: the joint's localToWorld times its inverse bind matrix
void skin(const Primitive& primitive, std::span<const glm::mat4> skinToWorld, Geometry& geometry);

} // namespace glint::scene
