#include "lab/scene/builtin/sweep.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// One cross-section of a tube. `across` and `up` span its circle: cross(across, up) = along.
struct Ring {
    glm::vec3 center, across, up, along;
    float radius = 0;
    float tilt = 0; ///< radians by which the normal leans from the circle's plane towards `along`: the end caps
    float v = 0;
};

glm::vec3 pathDirection(std::span<const glm::vec3> path, size_t i, bool closed) {
    const size_t n = path.size();
    const size_t before = i > 0 ? i - 1 : (closed ? n - 1 : 0);
    const size_t after = i + 1 < n ? i + 1 : (closed ? 0 : n - 1);
    return glm::normalize(path[after] - path[before]);
}

/// Moves `across` to the next cross-section with minimal rotation: removes its component along the path.
glm::vec3 transported(const glm::vec3& across, const glm::vec3& along) {
    return glm::normalize(across - along * glm::dot(across, along));
}

std::vector<Ring> ringsAlong(std::span<const glm::vec3> path, float radius, bool closed) {
    const glm::vec3 first = pathDirection(path, 0, closed);
    glm::vec3 across = transported(std::abs(first.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), first);
    std::vector<Ring> rings;
    for (size_t i = 0; i < path.size(); ++i) {
        const glm::vec3 along = pathDirection(path, i, closed);
        across = transported(across, along);
        const float v = static_cast<float>(i) / static_cast<float>(closed ? path.size() : path.size() - 1);
        rings.push_back({path[i], across, glm::cross(along, across), along, radius, 0, v});
    }
    if (!closed)
        return rings;

    // After one loop the frame is rotated by some angle: distribute it over the length.
    const glm::vec3 back = transported(across, first);
    const float twist = std::atan2(glm::dot(back, rings[0].up), glm::dot(back, rings[0].across));
    for (Ring& ring : rings) {
        const float angle = -twist * ring.v;
        ring.across = std::cos(angle) * ring.across + std::sin(angle) * ring.up;
        ring.up = glm::cross(ring.along, ring.across);
    }
    rings.push_back(rings.front());
    rings.back().v = 1;
    return rings;
}

/// The rings of a half sphere at one end, from its pole inward (at the start) or from the rim outward (at the end).
std::vector<Ring> capRings(const Ring& end, bool atStart, int segments) {
    std::vector<Ring> rings;
    for (int i = segments; i > 0; --i) {
        Ring ring = end;
        ring.tilt =
            (atStart ? -1.f : 1.f) * glm::half_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
        ring.center += end.along * end.radius * std::sin(ring.tilt);
        ring.radius = i == segments ? 0 : end.radius * std::cos(ring.tilt);
        rings.push_back(ring);
    }
    if (!atStart)
        std::ranges::reverse(rings);
    return rings;
}

} // namespace

Geometry tube(std::span<const glm::vec3> path, float radius, int columns, bool closed) {
    constexpr int kCapSegments = 4;
    std::vector<Ring> rings = ringsAlong(path, radius, closed);
    if (!closed) {
        const auto startCap = capRings(rings.front(), true, kCapSegments);
        const auto endCap = capRings(rings.back(), false, kCapSegments);
        rings.insert(rings.begin(), startCap.begin(), startCap.end());
        rings.insert(rings.end(), endCap.begin(), endCap.end());
    }
    Geometry out = lattice(columns, static_cast<int>(rings.size()) - 1, [&](int column, int row) {
        const Ring& ring = rings[static_cast<size_t>(row)];
        const float angle = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
        const glm::vec3 outward = std::cos(angle) * ring.across + std::sin(angle) * ring.up;
        return SurfacePoint{ring.center + outward * ring.radius,
                            outward * std::cos(ring.tilt) + ring.along * std::sin(ring.tilt),
                            {static_cast<float>(column) / static_cast<float>(columns), 1 - ring.v}};
    });
    computeTangents(out);
    return out;
}

std::vector<glm::vec3> roundedPolyline(std::span<const glm::vec3> corners, float radius, int segments) {
    std::vector<glm::vec3> path = {corners.front()};
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::vec3 toBefore = corners[i - 1] - corners[i], toAfter = corners[i + 1] - corners[i];
        const glm::vec3 a = glm::normalize(toBefore), b = glm::normalize(toAfter);
        const float halfAngle = 0.5f * std::acos(std::clamp(glm::dot(a, b), -1.f, 1.f));
        const float leg =
            std::min(radius / std::tan(halfAngle), 0.45f * std::min(glm::length(toBefore), glm::length(toAfter)));
        const float fitted = leg * std::tan(halfAngle);
        const glm::vec3 inward = glm::normalize(a + b);
        const glm::vec3 center = corners[i] + inward * (fitted / std::sin(halfAngle));
        // The path arrives along -a and leaves along b: the radius vector turns by pi - 2 * halfAngle.
        const glm::vec3 start = corners[i] + a * leg - center;
        const float sweep = glm::pi<float>() - 2 * halfAngle;
        for (int k = 0; k <= segments; ++k) {
            const float angle = sweep * static_cast<float>(k) / static_cast<float>(segments);
            path.push_back(center + start * std::cos(angle) - a * fitted * std::sin(angle));
        }
    }
    path.push_back(corners.back());
    return path;
}

Geometry torusKnot(int p, int q, float radius, float tubeRadius, int rows, int columns) {
    std::vector<glm::vec3> path;
    for (int i = 0; i < rows; ++i) {
        const float t = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(rows);
        const float wide = radius * (0.7f + 0.3f * std::cos(static_cast<float>(q) * t));
        path.emplace_back(wide * std::sin(static_cast<float>(p) * t),
                          0.45f * radius * std::sin(static_cast<float>(q) * t),
                          wide * std::cos(static_cast<float>(p) * t));
    }
    return tube(path, tubeRadius, columns, true);
}

} // namespace glint::scene::builtin
