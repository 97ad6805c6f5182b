// Tubes along a path: neon, rails, knots.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <span>
#include <vector>

namespace glint::scene::builtin {

/// A round tube along `path` (at least two points, no two neighbours equal). Closed paths join without twist; their
/// last point must differ from their first. Open paths end in half spheres. uvs: u around, v 0..1 along.
Geometry tube(std::span<const glm::vec3> path, float radius, int columns = 10, bool closed = false);

/// Replaces each corner of a polyline by an arc of `radius`, or less where its legs are short.
std::vector<glm::vec3> roundedPolyline(std::span<const glm::vec3> corners, float radius, int segments = 6);

/// A (p, q) torus knot: p times around +Y, q times through the ring's hole; its extent is about radius + tubeRadius.
Geometry torusKnot(int p, int q, float radius, float tubeRadius, int rows = 240, int columns = 16);

} // namespace glint::scene::builtin
