#include "rays/mesh.hpp"

#include <cstring>

namespace glint::rays {
namespace {

glm::vec3 readPosition(const float* positions, size_t vertex, uint32_t stride) {
    glm::vec3 position;
    std::memcpy(&position, reinterpret_cast<const std::byte*>(positions) + vertex * stride, sizeof(position));
    return position;
}

bool isSomewhere(const glm::vec3& p) {
    return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest; // false for NaN
}

} // namespace

Result<Mesh> readMesh(const RayMesh& source, uint32_t number) {
    if (source.vertexCount > 0 && !source.positions)
        return invalidArgument("ray mesh {}: {} vertices without positions", number, source.vertexCount);
    if (source.vertexStride < 3 * sizeof(float))
        return invalidArgument("ray mesh {}: a stride of {} bytes, but a position has 12", number, source.vertexStride);
    if (source.indices.size() % 3 != 0)
        return invalidArgument("ray mesh {}: {} indices are no whole triangles", number, source.indices.size());
    if (source.indices.size() / 3 > kMostTriangles)
        return invalidArgument("ray mesh {}: {} triangles, at most {} can be had", number, source.indices.size() / 3,
                               kMostTriangles);
    Mesh mesh;
    mesh.deforms = source.deforms;
    mesh.positions.reserve(source.vertexCount);
    std::vector<bool> nowhere(source.vertexCount, false);
    for (size_t i = 0; i < source.vertexCount; ++i) {
        const glm::vec3 position = readPosition(source.positions, i, source.vertexStride);
        nowhere[i] = !isSomewhere(position);
        mesh.positions.push_back(nowhere[i] ? glm::vec3(0) : position);
    }
    mesh.triangles.reserve(source.indices.size() / 3);
    for (size_t i = 0; i < source.indices.size(); i += 3) {
        const glm::uvec3 triangle(source.indices[i], source.indices[i + 1], source.indices[i + 2]);
        for (int corner = 0; corner < 3; ++corner)
            if (triangle[corner] >= source.vertexCount)
                return invalidArgument("ray mesh {}: triangle {} refers to vertex {} of {}", number, i / 3,
                                       triangle[corner], source.vertexCount);
        const bool leaveOut = nowhere[triangle.x] || nowhere[triangle.y] || nowhere[triangle.z];
        mesh.triangles.push_back(leaveOut ? glm::uvec3(triangle.x) : triangle);
    }
    return mesh;
}

void moveVertices(Mesh& mesh, const float* positions, uint32_t vertexStride) {
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (const glm::vec3 position = readPosition(positions, i, vertexStride); isSomewhere(position))
            mesh.positions[i] = position;
}

Bounds boundsOf(const Mesh& mesh, const glm::uvec3& triangle) {
    Bounds bounds;
    for (int corner = 0; corner < 3; ++corner)
        bounds.add(mesh.positions[triangle[corner]]);
    return bounds;
}

} // namespace glint::rays
