// Flat normals, for files without normals and for such meshes after morphing.
#pragma once

#include "lab/scene/scene.hpp"

namespace glint::scene {

/// Returns the unit normal of a triangle, by the right-hand rule; +Z if the triangle has no area. Computed in double
/// precision, as the cross product of two short edges easily leaves the range of a float.
glm::vec3 triangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Sets the normals of each triangle's three vertices to the triangle's normal. No vertex may be shared between
/// triangles.
void computeFlatNormals(Geometry& geometry);

} // namespace glint::scene
