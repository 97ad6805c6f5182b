// Tangents for normal maps, compatible with baking tools.
#pragma once

#include "lab/scene/scene.hpp"

#include <vector>

namespace glint::scene {

/// Computes MikkTSpace tangent frames for each corner of each triangle, in the order of `geometry.indices`: xyz unit
/// and orthogonal to the vertex normal, w the sign for glTF's bitangent, cross(normal, tangent.xyz) * w.
///
/// Corners of a vertex agree unless its triangles are mirrored against each other in texture space or are not joined by
/// an edge; the caller splits such vertices. Triangles without area in texture space use the frame of a neighbour.
///
/// `geometry`  triangles with unit normals and a texture coordinate set `texCoord`
/// Based on: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", Master's thesis, University of Copenhagen,
/// section 2.5, and the properties listed at http://www.mikktspace.com. Required by glTF 2.0, section 3.7.2.1.
std::vector<glm::vec4> computeTangents(const Geometry& geometry, uint32_t texCoord);

/// Returns any unit vector orthogonal to unit `normal`, where no direction is preferred.
glm::vec3 anyTangent(const glm::vec3& normal);

} // namespace glint::scene
