#include "lab/scene/tangents.hpp"

#include "lab/scene/bit_key.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

// Names follow the thesis: a triangle's tangent is the first-order derivative of position by texture u, its orientation
// the sign of its area in the texture; vertices are grouped, and a group shares one tangent.
namespace glint::scene {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

/// Returns for each vertex the first with equal position, normal and texture coordinates, so that the result does not
/// depend on how a mesh is indexed.
std::vector<uint32_t> weldVertices(const Geometry& geometry, const std::vector<glm::vec2>& uvs) {
    std::unordered_map<BitKey<8>, uint32_t, BitKeyHash> ids;
    std::vector<uint32_t> welded(geometry.positions.size());
    for (size_t i = 0; i < welded.size(); ++i) {
        const glm::vec3 p = geometry.positions[i] + 0.0f; // -0 becomes 0
        const glm::vec3 n = geometry.normals[i] + 0.0f;
        const glm::vec2 uv = uvs[i] + 0.0f;
        const BitKey<8> key = {bitsOf(p.x), bitsOf(p.y), bitsOf(p.z),  bitsOf(n.x),
                               bitsOf(n.y), bitsOf(n.z), bitsOf(uv.x), bitsOf(uv.y)};
        welded[i] = ids.try_emplace(key, static_cast<uint32_t>(i)).first->second;
    }
    return welded;
}

struct Face {
    glm::vec3 tangent = glm::vec3(0); ///< unit; zero if the triangle has no area in texture space
    bool degenerate = false;          ///< two corners coincide: ignored
    int8_t orientation = 0;           ///< +1 or -1; 0: no area in texture space, compatible with both
};

Face makeFace(const Geometry& geometry, const std::vector<glm::vec2>& uvs, const uint32_t* corner) {
    Face face;
    const glm::vec3& p0 = geometry.positions[corner[0]];
    const glm::vec3& p1 = geometry.positions[corner[1]];
    const glm::vec3& p2 = geometry.positions[corner[2]];
    face.degenerate = p0 == p1 || p1 == p2 || p2 == p0;
    // Mikkelsen 2008, eq. 2.4: the derivative of position by u, times the area, as only its direction is needed.
    const glm::dvec3 d1 = glm::dvec3(p1) - glm::dvec3(p0);
    const glm::dvec3 d2 = glm::dvec3(p2) - glm::dvec3(p0);
    const glm::dvec2 t1 = glm::dvec2(uvs[corner[1]]) - glm::dvec2(uvs[corner[0]]);
    const glm::dvec2 t2 = glm::dvec2(uvs[corner[2]]) - glm::dvec2(uvs[corner[0]]);
    const double area = t1.x * t2.y - t1.y * t2.x;
    const glm::dvec3 derivative = (t2.y * d1 - t1.y * d2) * (area < 0 ? -1.0 : 1.0);
    const double length = glm::length(derivative);
    constexpr double kSmallest = std::numeric_limits<float>::min();
    if (face.degenerate || std::abs(area) <= kSmallest || !(length > kSmallest) || !std::isfinite(length))
        return face;
    face.tangent = glm::vec3(derivative / length);
    // glTF's v points down the image, the method's v up: its preserved orientation has negative area here.
    face.orientation = area < 0 ? 1 : -1;
    return face;
}

/// neighbours[corner]: the face across the edge from this corner to the next one of its triangle.
std::vector<uint32_t> findNeighbours(const std::vector<uint32_t>& cornerVertex, const std::vector<Face>& faces) {
    const auto next = [](size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    std::vector<uint32_t> neighbours(cornerVertex.size(), kNone);
    std::unordered_multimap<uint64_t, uint32_t> open; // edges still without a partner
    for (size_t corner = 0; corner < cornerVertex.size(); ++corner) {
        if (faces[corner / 3].degenerate)
            continue;
        const uint64_t from = cornerVertex[corner];
        const uint64_t to = cornerVertex[next(corner)];
        // Neighbours traverse their common edge in opposite directions.
        if (const auto partner = open.find(to << 32 | from); partner != open.end()) {
            neighbours[corner] = partner->second / 3;
            neighbours[partner->second] = static_cast<uint32_t>(corner / 3);
            open.erase(partner);
        } else {
            open.emplace(from << 32 | to, static_cast<uint32_t>(corner));
        }
    }
    return neighbours;
}

/// Faces without area in texture space take the orientation of the first neighbour that has one.
void spreadOrientation(std::vector<Face>& faces, const std::vector<uint32_t>& neighbours) {
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < faces.size(); ++i)
        if (faces[i].orientation != 0)
            open.push_back(i);
    for (size_t at = 0; at < open.size(); ++at) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t neighbour = neighbours[open[at] * size_t(3) + k];
            if (neighbour == kNone || faces[neighbour].orientation != 0)
                continue;
            faces[neighbour].orientation = faces[open[at]].orientation;
            open.push_back(neighbour);
        }
    }
}

/// Disjoint sets of corners.
class Groups {
public:
    explicit Groups(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    uint32_t find(uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) { parent_[find(b)] = find(a); }

private:
    std::vector<uint32_t> parent_;
};

/// Groups the corners of a vertex whose faces are connected by edges and have the same orientation.
Groups groupCorners(const std::vector<uint32_t>& cornerVertex, const std::vector<Face>& faces,
                    const std::vector<uint32_t>& neighbours) {
    Groups groups(cornerVertex.size());
    for (size_t corner = 0; corner < cornerVertex.size(); ++corner) {
        const uint32_t neighbour = neighbours[corner];
        if (neighbour == kNone || faces[neighbour].orientation != faces[corner / 3].orientation)
            continue;
        const size_t ends[2] = {corner, corner % 3 == 2 ? corner - 2 : corner + 1};
        for (const size_t end : ends)
            for (uint32_t k = 0; k < 3; ++k)
                if (cornerVertex[neighbour * size_t(3) + k] == cornerVertex[end])
                    groups.join(static_cast<uint32_t>(end), neighbour * 3 + k);
    }
    return groups;
}

glm::vec3 acrossNormal(const glm::vec3& v, const glm::vec3& normal) {
    const glm::vec3 across = v - normal * glm::dot(normal, v);
    const float length = glm::length(across);
    return length > 0 && std::isfinite(length) ? across / length : glm::vec3(0);
}

/// The face's tangent projected orthogonal to the vertex normal, weighted by the corner's angle seen along that normal.
glm::vec3 weightedTangent(const Geometry& geometry, const Face& face, const uint32_t* triangle, size_t k) {
    const uint32_t vertex = triangle[k];
    const glm::vec3& normal = geometry.normals[vertex];
    const glm::vec3& position = geometry.positions[vertex];
    const glm::vec3 toNext = acrossNormal(geometry.positions[triangle[(k + 1) % 3]] - position, normal);
    const glm::vec3 toPrevious = acrossNormal(geometry.positions[triangle[(k + 2) % 3]] - position, normal);
    const float angle = std::acos(std::clamp(glm::dot(toNext, toPrevious), -1.0f, 1.0f));
    return acrossNormal(face.tangent, normal) * angle;
}

} // namespace

glm::vec3 anyTangent(const glm::vec3& normal) {
    // Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3.
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    return {1.0f + sign * normal.x * normal.x * a, sign * normal.x * normal.y * a, -sign * normal.x};
}

std::vector<glm::vec4> computeTangents(const Geometry& geometry, uint32_t texCoord) {
    const std::vector<glm::vec2>& uvs = geometry.uvs[texCoord];
    const size_t cornerCount = geometry.indices.size() / 3 * 3;

    const std::vector<uint32_t> welded = weldVertices(geometry, uvs);
    std::vector<uint32_t> cornerVertex(cornerCount);
    for (size_t i = 0; i < cornerCount; ++i)
        cornerVertex[i] = welded[geometry.indices[i]];
    std::vector<Face> faces(cornerCount / 3);
    for (size_t i = 0; i < faces.size(); ++i)
        faces[i] = makeFace(geometry, uvs, &geometry.indices[i * 3]);
    const std::vector<uint32_t> neighbours = findNeighbours(cornerVertex, faces);
    spreadOrientation(faces, neighbours);
    Groups groups = groupCorners(cornerVertex, faces, neighbours);

    std::vector<glm::vec3> sums(cornerCount, glm::vec3(0)); // at the group's representative
    for (uint32_t i = 0; i < cornerCount; ++i)
        sums[groups.find(i)] += weightedTangent(geometry, faces[i / 3], &geometry.indices[i / 3 * size_t(3)], i % 3);

    std::vector<glm::vec4> tangents(cornerCount, glm::vec4(0));
    std::unordered_map<uint32_t, glm::vec4> tangentOfVertex; // for corners without their own
    for (uint32_t i = 0; i < cornerCount; ++i) {
        const glm::vec3 direction = acrossNormal(sums[groups.find(i)], geometry.normals[geometry.indices[i]]);
        if (direction == glm::vec3(0))
            continue;
        tangents[i] = glm::vec4(direction, faces[i / 3].orientation);
        tangentOfVertex.try_emplace(cornerVertex[i], tangents[i]);
    }
    for (uint32_t i = 0; i < cornerCount; ++i) {
        if (tangents[i].w != 0)
            continue;
        const auto borrowed = tangentOfVertex.find(cornerVertex[i]);
        tangents[i] = borrowed != tangentOfVertex.end()
                          ? borrowed->second
                          : glm::vec4(anyTangent(geometry.normals[geometry.indices[i]]), 1);
    }
    return tangents;
}

} // namespace glint::scene
