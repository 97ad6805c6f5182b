// Tools for procedural shapes: lattices of points, joining, transforms, tangents.
#pragma once

#include "lab/scene/scene.hpp"

#include <glm/glm.hpp>

#include <functional>

namespace glint::scene::builtin {

/// A point of a surface, as returned by a shape's formula.
struct SurfacePoint {
    glm::vec3 position = glm::vec3(0);     ///< metres
    glm::vec3 normal = glm::vec3(0, 0, 1); ///< unit, outward
    glm::vec2 uv = glm::vec2(0);           ///< v grows downward in the image, as in glTF
};

/// Joins (columns + 1) x (rows + 1) points into triangles. The front is the side on which columns run to the right and
/// rows run up. A closed shape repeats its first points bit for bit at the end, so that seams stay watertight.
/// Triangles that collapse (at a pole) are left out.
Geometry lattice(int columns, int rows, const std::function<SurfacePoint(int column, int row)>& point);

/// Appends one flat face: corners counter-clockwise seen from the front, uvs in the same order.
void appendQuad(Geometry& to, const std::array<glm::vec3, 4>& corners, const std::array<glm::vec2, 4>& uvs);

/// Appends the triangles of `from` to `to`, in the same primitive.
void append(Geometry& to, const Geometry& from);

/// Transforms a shape. `transform` may scale non-uniformly, but must not mirror.
Geometry transformed(Geometry geometry, const glm::mat4& transform);
Geometry translated(Geometry geometry, const glm::vec3& offset);

/// Computes tangents from positions and uvs (Lengyel 2001, "Computing Tangent Space Basis Vectors for an Arbitrary
/// Mesh"). Vertices without a usable uv direction get any tangent orthogonal to their normal.
void computeTangents(Geometry& geometry);

} // namespace glint::scene::builtin
