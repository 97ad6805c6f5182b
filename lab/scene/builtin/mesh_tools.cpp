#include "lab/scene/builtin/mesh_tools.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace glint::scene::builtin {

namespace {

void appendTriangle(Geometry& to, uint32_t a, uint32_t b, uint32_t c) {
    const auto& p = to.positions;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a])
        return;
    to.indices.insert(to.indices.end(), {a, b, c});
}

/// Any unit vector orthogonal to `normal`.
glm::vec3 anyTangent(const glm::vec3& normal) {
    const glm::vec3 helper = std::abs(normal.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(helper - normal * glm::dot(normal, helper));
}

} // namespace

Geometry lattice(int columns, int rows, const std::function<SurfacePoint(int, int)>& point) {
    Geometry out;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const SurfacePoint p = point(column, row);
            out.positions.push_back(p.position);
            out.normals.push_back(p.normal);
            out.uvs[0].push_back(p.uv);
        }
    }
    const auto index = [&](int column, int row) { return static_cast<uint32_t>(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            appendTriangle(out, index(column, row), index(column + 1, row), index(column + 1, row + 1));
            appendTriangle(out, index(column, row), index(column + 1, row + 1), index(column, row + 1));
        }
    }
    return out;
}

void appendQuad(Geometry& to, const std::array<glm::vec3, 4>& corners, const std::array<glm::vec2, 4>& uvs) {
    const auto first = static_cast<uint32_t>(to.positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (size_t i = 0; i < 4; ++i) {
        to.positions.push_back(corners[i]);
        to.normals.push_back(normal);
        to.uvs[0].push_back(uvs[i]);
    }
    appendTriangle(to, first, first + 1, first + 2);
    appendTriangle(to, first, first + 2, first + 3);
}

void append(Geometry& to, const Geometry& from) {
    const auto first = static_cast<uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    to.tangents.insert(to.tangents.end(), from.tangents.begin(), from.tangents.end());
    to.uvs[0].insert(to.uvs[0].end(), from.uvs[0].begin(), from.uvs[0].end());
    for (const uint32_t index : from.indices)
        to.indices.push_back(first + index);
}

Geometry transformed(Geometry geometry, const glm::mat4& transform) {
    const glm::mat3 linear(transform);
    const glm::mat3 normalMatrix = glm::transpose(glm::inverse(linear));
    for (glm::vec3& p : geometry.positions)
        p = glm::vec3(transform * glm::vec4(p, 1));
    for (glm::vec3& n : geometry.normals)
        n = glm::normalize(normalMatrix * n);
    for (glm::vec4& t : geometry.tangents)
        t = glm::vec4(glm::normalize(linear * glm::vec3(t)), t.w);
    return geometry;
}

Geometry translated(Geometry geometry, const glm::vec3& offset) {
    for (glm::vec3& p : geometry.positions)
        p += offset;
    return geometry;
}

void computeTangents(Geometry& geometry) {
    const size_t count = geometry.positions.size();
    std::vector<glm::vec3> alongU(count, glm::vec3(0));
    std::vector<glm::vec3> alongV(count, glm::vec3(0));
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
        const uint32_t* corner = &geometry.indices[i];
        const glm::vec3 edge1 = geometry.positions[corner[1]] - geometry.positions[corner[0]];
        const glm::vec3 edge2 = geometry.positions[corner[2]] - geometry.positions[corner[0]];
        const glm::vec2 uv1 = geometry.uvs[0][corner[1]] - geometry.uvs[0][corner[0]];
        const glm::vec2 uv2 = geometry.uvs[0][corner[2]] - geometry.uvs[0][corner[0]];
        const float area = uv1.x * uv2.y - uv2.x * uv1.y;
        if (std::abs(area) < 1e-12f)
            continue;
        for (int k = 0; k < 3; ++k) {
            alongU[corner[k]] += (edge1 * uv2.y - edge2 * uv1.y) / area;
            alongV[corner[k]] += (edge2 * uv1.x - edge1 * uv2.x) / area;
        }
    }
    geometry.tangents.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3& normal = geometry.normals[i];
        const glm::vec3 projected = alongU[i] - normal * glm::dot(normal, alongU[i]);
        const float length = glm::length(projected);
        const glm::vec3 tangent =
            length > 1e-6f * glm::length(alongU[i]) && length > 0 ? projected / length : anyTangent(normal);
        // In glTF v points down the image, but a normal map's green points up: the bitangent is opposite to v.
        const float w = glm::dot(glm::cross(normal, tangent), alongV[i]) > 0 ? -1.f : 1.f;
        geometry.tangents[i] = glm::vec4(tangent, w);
    }
}

} // namespace glint::scene::builtin
