#include "lab/scene/gltf/shading_frames.hpp"

#include "lab/scene/bit_key.hpp"
#include "lab/scene/gltf/vertices.hpp"
#include "lab/scene/normals.hpp"
#include "lab/scene/tangents.hpp"

#include <cmath>
#include <numeric>
#include <unordered_map>

namespace glint::scene::gltf {
namespace {

/// Normalizes `v`; false if it has no direction.
bool tryNormalize(glm::vec3& v) {
    const glm::dvec3 wide(v);
    const double length = glm::length(wide);
    if (!(length > 1e-20) || !std::isfinite(length))
        return false;
    v = glm::vec3(wide / length);
    return true;
}

/// Returns for every vertex the area-weighted sum of its faces' normals.
std::vector<glm::dvec3> facesAroundVertices(const Geometry& geometry) {
    std::vector<glm::dvec3> sums(geometry.positions.size(), glm::dvec3(0));
    if (geometry.topology != Topology::Triangles)
        return sums;
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
        const uint32_t* corner = &geometry.indices[i];
        const glm::dvec3 origin(geometry.positions[corner[0]]);
        const glm::dvec3 normal = glm::cross(glm::dvec3(geometry.positions[corner[1]]) - origin,
                                             glm::dvec3(geometry.positions[corner[2]]) - origin);
        for (int k = 0; k < 3; ++k)
            sums[corner[k]] += normal;
    }
    return sums;
}

} // namespace

void repairShadingFrames(Geometry& geometry) {
    std::vector<glm::dvec3> faces; // computed for the first normal that needs them
    for (size_t i = 0; i < geometry.normals.size(); ++i) {
        if (tryNormalize(geometry.normals[i]))
            continue;
        if (faces.empty())
            faces = facesAroundVertices(geometry);
        const double length = glm::length(faces[i]);
        geometry.normals[i] = length > 0 ? glm::vec3(faces[i] / length) : glm::vec3(0, 0, 1);
    }
    for (size_t i = 0; i < geometry.tangents.size(); ++i) {
        glm::vec3 direction(geometry.tangents[i]);
        if (!tryNormalize(direction))
            direction = anyTangent(geometry.normals[i]);
        geometry.tangents[i] = glm::vec4(direction, geometry.tangents[i].w < 0 ? -1.0f : 1.0f);
    }
}

void makeFlatNormals(Document& document, Primitive& primitive) {
    Geometry& geometry = primitive.geometry;
    geometry.tangents.clear();
    if (!document.reserve(geometry.indices.size() * (bytesPerVertex(primitive) + sizeof(glm::vec3)),
                          "a mesh without normals"))
        return;
    gatherVertices(primitive, geometry.indices);
    std::iota(geometry.indices.begin(), geometry.indices.end(), 0u);
    computeFlatNormals(geometry);
    primitive.flatNormals = true;
}

void makeTangents(Document& document, Primitive& primitive, uint32_t texCoord) {
    Geometry& geometry = primitive.geometry;
    if (geometry.topology != Topology::Triangles || geometry.normals.empty() || geometry.uvs[texCoord].empty())
        return;
    const uint64_t cornerBytes = bytesPerVertex(primitive) + sizeof(glm::vec4) + 64; // 64: welding tables
    if (!document.reserve(geometry.indices.size() * cornerBytes, "a mesh without tangents"))
        return;
    const std::vector<glm::vec4> cornerTangents = computeTangents(geometry, texCoord);

    std::unordered_map<BitKey<5>, uint32_t, BitKeyHash> newIndexOf; // old vertex and its tangent
    newIndexOf.reserve(geometry.positions.size());
    std::vector<uint32_t> sources;
    std::vector<glm::vec4> tangents;
    for (size_t corner = 0; corner < geometry.indices.size(); ++corner) {
        const uint32_t vertex = geometry.indices[corner];
        const glm::vec4& t = cornerTangents[corner];
        const BitKey<5> key = {vertex, bitsOf(t.x), bitsOf(t.y), bitsOf(t.z), bitsOf(t.w)};
        const auto [entry, isNew] = newIndexOf.try_emplace(key, static_cast<uint32_t>(sources.size()));
        if (isNew) {
            sources.push_back(vertex);
            tangents.push_back(t);
        }
        geometry.indices[corner] = entry->second;
    }
    gatherVertices(primitive, sources);
    geometry.tangents = std::move(tangents);
}

} // namespace glint::scene::gltf
