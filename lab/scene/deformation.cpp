#include "lab/scene/deformation.hpp"

#include "lab/scene/normals.hpp"
#include "lab/scene/tangents.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene {
namespace {

/// Returns `fallback` if `v` cannot be normalized.
glm::vec3 normalizedOr(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : fallback;
}

/// The transposed inverse times the determinant; also defined for singular matrices.
glm::mat3 cofactors(const glm::mat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void makeTangentsFit(Geometry& geometry) {
    for (size_t i = 0; i < geometry.tangents.size(); ++i) {
        const glm::vec3& normal = geometry.normals[i];
        const glm::vec3 tangent(geometry.tangents[i]);
        const glm::vec3 across = tangent - normal * glm::dot(normal, tangent);
        geometry.tangents[i] = glm::vec4(normalizedOr(across, anyTangent(normal)), geometry.tangents[i].w);
    }
}

/// The weighted sum of a vertex's joint matrices. Weights are normalized, as exporters round them.
glm::mat4 blendJoints(const Primitive& primitive, std::span<const glm::mat4> skinToWorld, size_t vertex) {
    glm::mat4 sum(0);
    float total = 0;
    for (const SkinSet& set : primitive.skinSets) {
        for (int k = 0; k < 4; ++k) {
            const float weight = set.weights[vertex][k];
            if (weight <= 0)
                continue;
            sum += skinToWorld[set.joints[vertex][k]] * weight;
            total += weight;
        }
    }
    return total > 0 ? sum * (1 / total) : skinToWorld[0]; // all weights 0: use the first joint
}

void turnTriangles(Geometry& geometry, const std::vector<bool>& mirrored) {
    if (geometry.topology != Topology::Triangles)
        return;
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3)
        if (mirrored[geometry.indices[i]])
            std::swap(geometry.indices[i + 1], geometry.indices[i + 2]);
}

} // namespace

void morph(const Primitive& primitive, std::span<const float> weights, Geometry& geometry) {
    for (size_t t = 0; t < primitive.morphTargets.size(); ++t) {
        const MorphTarget& target = primitive.morphTargets[t];
        if (weights[t] == 0)
            continue;
        for (size_t i = 0; i < target.positions.size(); ++i)
            geometry.positions[i] += target.positions[i] * weights[t];
        if (!primitive.flatNormals && !geometry.normals.empty())
            for (size_t i = 0; i < target.normals.size(); ++i)
                geometry.normals[i] += target.normals[i] * weights[t];
        if (!geometry.tangents.empty())
            for (size_t i = 0; i < target.tangents.size(); ++i)
                geometry.tangents[i] += glm::vec4(target.tangents[i] * weights[t], 0);
    }
    if (primitive.flatNormals)
        computeFlatNormals(geometry);
    for (size_t i = 0; i < geometry.normals.size(); ++i)
        geometry.normals[i] = normalizedOr(geometry.normals[i], primitive.geometry.normals[i]);
    makeTangentsFit(geometry);
}

void skin(const Primitive& primitive, std::span<const glm::mat4> skinToWorld, Geometry& geometry) {
    std::vector<bool> mirrored(geometry.positions.size());
    for (size_t i = 0; i < geometry.positions.size(); ++i) {
        const glm::mat4 localToWorld = blendJoints(primitive, skinToWorld, i);
        const glm::mat3 linear(localToWorld);
        mirrored[i] = glm::determinant(linear) < 0;
        const float side = mirrored[i] ? -1.0f : 1.0f;
        geometry.positions[i] = glm::vec3(localToWorld * glm::vec4(geometry.positions[i], 1));
        if (!geometry.normals.empty())
            geometry.normals[i] = normalizedOr(cofactors(linear) * geometry.normals[i] * side, glm::vec3(0, 0, 1));
        if (!geometry.tangents.empty())
            geometry.tangents[i] = glm::vec4(linear * glm::vec3(geometry.tangents[i]), geometry.tangents[i].w * side);
    }
    makeTangentsFit(geometry);
    turnTriangles(geometry, mirrored);
}

} // namespace glint::scene
