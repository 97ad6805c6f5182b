// A host's mesh as both back ends take it: checked, packed, and without what no ray may meet.
#pragma once

#include "base/result.hpp"
#include "glint/ray_scene.hpp"
#include "rays/bounds.hpp"

#include <vector>

namespace glint::rays {

/// Positions farther out than this, and NaN, are nowhere: squared distances still fit a float.
constexpr float kFarthest = 1e18f;

/// In a mesh: every device with ray queries takes so many (Vulkan 1.3, "Required Limits").
constexpr size_t kMostTriangles = (size_t{1} << 29) - 1;

struct Mesh {
    std::vector<glm::vec3> positions;  ///< all finite
    std::vector<glm::uvec3> triangles; ///< in the host's order; all below positions.size()
    bool deforms = false;
};

/// A triangle that was left out keeps its number and has three times the same vertex.
inline bool isLeftOut(const glm::uvec3& triangle) {
    return triangle.x == triangle.y && triangle.y == triangle.z;
}

/// Errors: InvalidArgument, with `number`, for an index out of range, a number of indices that is no multiple of three,
/// or missing positions.
Result<Mesh> readMesh(const RayMesh& mesh, uint32_t number);

/// Takes over new positions; one that is nowhere keeps its old place.
void moveVertices(Mesh& mesh, const float* positions, uint32_t vertexStride);

Bounds boundsOf(const Mesh& mesh, const glm::uvec3& triangle);

} // namespace glint::rays
