// Flat normals, for files that bring none and for such meshes after morphing.
#pragma once

#include "scene/scene.hpp"

namespace glint::scene {

/// Unit normal of a triangle, by the right-hand rule; +Z where it has no area. Computed in double precision, since the
/// cross product of two small edges soon leaves the range of a float.
glm::vec3 triangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Gives the three vertices of each triangle its normal. No vertex may be shared between triangles.
void computeFlatNormals(Geometry& geometry);

} // namespace glint::scene
