// A host's mesh in the form that both back ends use: checked, packed, and without triangles that no ray may intersect.
#pragma once

#include "base/result.hpp"
#include "glint/ray_scene.hpp"
#include "rays/bounds.hpp"

#include <vector>

namespace glint::rays {

/// Positions beyond this distance, and NaN, are invalid. Squared distances up to it fit a float.
constexpr float kFarthest = 1e18f;

/// Maximum triangles per mesh, which every device with ray queries supports (Vulkan 1.3, "Required Limits").
constexpr size_t kMostTriangles = (size_t{1} << 29) - 1;

struct Mesh {
    std::vector<glm::vec3> positions;  ///< all finite
    std::vector<glm::uvec3> triangles; ///< in the host's order; all below positions.size()
    bool deforms = false;
};

/// A triangle that was left out keeps its number and has the same vertex three times.
inline bool isLeftOut(const glm::uvec3& triangle) {
    return triangle.x == triangle.y && triangle.y == triangle.z;
}

/// Errors: InvalidArgument, with `number`, for an index out of range, an index count that is not a multiple of three,
/// or missing positions.
Result<Mesh> readMesh(const RayMesh& mesh, uint32_t number);

/// Copies new positions into the mesh; a vertex whose new position is invalid keeps its old one.
void moveVertices(Mesh& mesh, const float* positions, uint32_t vertexStride);

Bounds boundsOf(const Mesh& mesh, const glm::uvec3& triangle);

} // namespace glint::rays
