// Tangents for normal maps, as every baking tool makes them.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace glint::scene {

/// Tangent frames after MikkTSpace for each corner of each triangle, in the order of `geometry.indices`: xyz unit and
/// across the vertex normal, w the sign for glTF's bitangent, cross(normal, tangent.xyz) * w.
///
/// Corners of a vertex agree unless its triangles are mirrored against each other in texture space or are joined by no
/// edge; the caller splits such vertices. Triangles without area on the picture borrow from a neighbour.
///
/// `geometry` triangles with unit normals and a texture coordinate set `texCoord`
/// Based on: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", Master's thesis, University of Copenhagen,
/// section 2.5, and the properties listed at http://www.mikktspace.com. glTF 2.0, section 3.7.2.1, asks for it.
std::vector<glm::vec4> computeTangents(const Geometry& geometry, uint32_t texCoord);

/// A unit vector across unit `normal`, for where nothing says which.
glm::vec3 anyTangent(const glm::vec3& normal);

} // namespace glint::scene
