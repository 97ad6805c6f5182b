// Morph targets and skins: moves vertices on the CPU, once per pose. Based on: glTF 2.0 specification, sections
// 3.7.2.2, "Morph Targets", and 3.7.3, "Skins".
#pragma once

#include "lab/scene/scene.hpp"

#include <span>

namespace glint::scene {

/// Adds the weighted differences of `primitive`'s targets to `geometry`, a copy of the primitive's own. Normals and
/// tangents stay unit and orthogonal; flat normals are recomputed from the moved vertices. Tangents that the reader
/// computed are moved too, rather than recomputed for every pose, which the specification only recommends.
///
/// `weights`    one per target
void morph(const Primitive& primitive, std::span<const float> weights, Geometry& geometry);

/// Moves every vertex by the weighted sum of its joints' matrices. Where that sum mirrors, triangle winding and tangent
/// handedness are reversed, so that front faces stay front faces: a skinned draw has no matrix with a determinant.
///
/// `skinToWorld`    one per joint: the joint's localToWorld times its inverse bind matrix
void skin(const Primitive& primitive, std::span<const glm::mat4> skinToWorld, Geometry& geometry);

} // namespace glint::scene
