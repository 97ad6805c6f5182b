#include "lab/measure/truth/ray_list.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace glint::measure {
namespace {

constexpr uint32_t kTile = 8;         // pixels
constexpr float kBounceStart = 1e-3f; // metres: clear of the triangle that the ray starts on

float unitNumber(std::mt19937& random) {
    // The distributions of the standard library differ between implementations.
    return static_cast<float>(random() >> 8) * 0x1p-24f;
}

/// Malley's method around a unit normal: a point of the unit sphere plus the normal.
glm::vec3 cosineDirection(const glm::vec3& normal, std::mt19937& random) {
    const float z = 1 - 2 * unitNumber(random);
    const float angle = glm::two_pi<float>() * unitNumber(random);
    const float around = std::sqrt(std::max(1 - z * z, 0.0f));
    const glm::vec3 sum = normal + glm::vec3(around * std::cos(angle), around * std::sin(angle), z);
    return glm::dot(sum, sum) > 1e-6f ? glm::normalize(sum) : normal;
}

} // namespace

std::vector<ListedRay> cameraRays(uint32_t count) {
    const auto tiles = static_cast<uint32_t>(std::max(1L, std::lround(std::sqrt(double(count)) / kTile)));
    const glm::vec3 origin(0, 7, 17);
    const glm::vec3 forward = glm::normalize(glm::vec3(0, 1, 0) - origin);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    const glm::vec3 up = glm::cross(right, forward);
    constexpr float kHalfHeight = 0.5f; // of the image, at a distance of one metre
    std::vector<ListedRay> rays;
    rays.reserve(size_t{tiles} * tiles * kTile * kTile);
    for (uint32_t i = 0; i < tiles * tiles * kTile * kTile; ++i) {
        const uint32_t tile = i / (kTile * kTile);
        const uint32_t x = tile % tiles * kTile + i % kTile;
        const uint32_t y = tile / tiles * kTile + i / kTile % kTile;
        const glm::vec2 point =
            (glm::vec2(x, y) + 0.5f) * (2 * kHalfHeight / static_cast<float>(tiles * kTile)) - kHalfHeight;
        ListedRay ray;
        ray.originWS = origin;
        ray.directionWS = glm::normalize(forward + point.x * right - point.y * up);
        rays.push_back(ray);
    }
    return rays;
}

std::vector<ListedRay> bounceRays(const RayBenchScene& scene, std::span<const ListedRay> rays,
                                  std::span<const ListedHit> hits) {
    std::vector<size_t> met;
    for (size_t i = 0; i < hits.size(); ++i)
        if (hits[i].met())
            met.push_back(i);
    std::vector<ListedRay> bounces;
    bounces.reserve(rays.size());
    std::mt19937 random(42);
    for (size_t i = 0; i < rays.size() && !met.empty(); ++i) {
        const size_t from = met[i * met.size() / rays.size()]; // some hits are used twice, in place of the misses
        const ListedRay& ray = rays[from];
        const auto corners = scene.triangleWS(hits[from].instance, hits[from].primitive);
        glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        if (glm::dot(normal, ray.directionWS) > 0)
            normal = -normal;
        ListedRay bounce;
        bounce.originWS = ray.originWS + hits[from].distance * ray.directionWS;
        bounce.directionWS = cosineDirection(normal, random);
        bounce.tMin = kBounceStart;
        bounces.push_back(bounce);
    }
    return bounces;
}

uint64_t differingHits(std::span<const ListedRay> rays, std::span<const ListedHit> a, std::span<const ListedHit> b) {
    uint64_t differ = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        // Mesa's lavapipe loses four bits of the origin in the transform to an instance's space.
        const float lost = 0x1p-20f * glm::length(rays[i].originWS);
        const bool same = a[i].met() == b[i].met() &&
                          (!a[i].met() || std::abs(a[i].distance - b[i].distance) <= 1e-4f * a[i].distance + lost);
        differ += same ? 0 : 1;
    }
    return differ;
}

} // namespace glint::measure
