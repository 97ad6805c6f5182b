// Small scenes whose reflections can be computed by hand.
#pragma once

#include "gpu/support/synthetic_gbuffer.hpp"

namespace glint::test {

/// An upright rectangle that faces +Z, or has the normal `normalWS`.
struct Card {
    glm::dvec2 low = {-1e9, -1e9}; ///< x, y
    glm::dvec2 high = {1e9, 1e9};
    double z = 0;
    glm::dvec3 normalWS = {0, 0, 1};
    float f0 = 0;
    float perceptualRoughness = 0;

    std::optional<double> distance(const glm::dvec3& origin, const glm::dvec3& direction) const {
        const double t = (z - origin.z) / direction.z;
        const glm::dvec3 p = origin + direction * t;
        const bool inside = p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y;
        return std::isfinite(t) && t > 1e-9 && inside ? std::optional(t) : std::nullopt;
    }
};

/// A mirror floor at y = 0 and cards over it. Every card's colour is its position.
struct Stage {
    bool floor = true;
    double floorEndZ = -1e9; ///< the floor lies on the camera's side of this z
    float floorF0 = 1;
    float floorRoughness = 0;
    std::vector<Card> cards;

    std::optional<SyntheticSurface> operator()(const glm::dvec3& origin, const glm::dvec3& direction) const {
        SyntheticSurface hit;
        hit.distance = 1e8;
        const double toFloor = -origin.y / direction.y;
        if (floor && toFloor > 1e-9 && toFloor < hit.distance && origin.z + direction.z * toFloor > floorEndZ) {
            hit.distance = toFloor;
            hit.f0 = glm::vec3(floorF0);
            hit.perceptualRoughness = floorRoughness;
        }
        for (const Card& card : cards)
            if (const auto t = card.distance(origin, direction); t && *t < hit.distance) {
                const glm::dvec3 position = origin + direction * *t;
                hit = {*t, card.normalWS, glm::vec3(card.f0), card.perceptualRoughness,
                       glm::vec3(position.x + 10, position.y + 10, 1)};
            }
        return hit.distance < 1e8 ? std::optional(hit) : std::nullopt;
    }
};

/// A floor before a wall at z = -3.
inline Stage floorAndWall() {
    Stage stage;
    stage.cards.push_back({.z = -3});
    return stage;
}

/// A white mirror in the plane z = 0, seen from above it.
inline std::optional<SyntheticSurface> flatMirror(const glm::dvec3& origin, const glm::dvec3& direction) {
    if (direction.z >= 0)
        return std::nullopt;
    SyntheticSurface hit;
    hit.distance = -origin.z / direction.z;
    hit.normalWS = {0, 0, 1};
    hit.f0 = glm::vec3(1);
    return hit;
}

/// A white metal ball of radius 1 around the origin.
inline SyntheticScene unitBall(float perceptualRoughness) {
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<SyntheticSurface> {
        const double middle = -glm::dot(origin, direction);
        const double inside = 1 - glm::dot(origin, origin) + middle * middle;
        if (inside < 0 || middle < 0)
            return std::nullopt;
        SyntheticSurface hit;
        hit.distance = middle - std::sqrt(inside);
        hit.normalWS = origin + direction * hit.distance;
        hit.f0 = glm::vec3(1);
        hit.perceptualRoughness = perceptualRoughness;
        return hit;
    };
}

/// The same scene; what reflects nothing has this radiance.
inline SyntheticScene litBy(const SyntheticScene& scene, const glm::vec3& radiance) {
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = scene(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = radiance;
        return hit;
    };
}

/// The volume that fits floorAndWall: of its six faces only that wall is near.
inline Probe wallVolume() {
    Probe probe;
    probe.influence = probe.proxyVolume = {{0, 0, 498.5f}, {0, 0, 0, 1}, {1000, 1000, 501.5f}};
    probe.influence.halfExtents = {1000, 1000, 502}; // the wall itself lies within
    return probe;
}

} // namespace glint::test
