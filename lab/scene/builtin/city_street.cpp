#include "lab/scene/builtin/city_street.hpp"

#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/sweep.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::scene::builtin {

namespace {

Geometry rounded(const glm::vec3& center, const glm::vec3& half, float radius, int segments) {
    return translated(roundedBox(half, radius, segments), center);
}

/// Narrows a shape linearly from `low` upward, to `scale` of its extents along X and Z at `high`.
Geometry tapered(Geometry geometry, float low, float high, const glm::vec2& scale) {
    const glm::vec2 slope = (scale - 1.f) / (high - low);
    for (size_t i = 0; i < geometry.positions.size(); ++i) {
        glm::vec3& p = geometry.positions[i];
        glm::vec3& n = geometry.normals[i];
        if (p.y < low)
            continue;
        const glm::vec2 narrow = 1.f + slope * (p.y - low);
        const glm::vec2 side = glm::vec2(n.x, n.z) / narrow; // by the inverse transpose of the Jacobian
        n = glm::normalize(glm::vec3(side.x, n.y - p.x * slope.x * side.x - p.z * slope.y * side.y, side.y));
        p = {p.x * narrow.x, p.y, p.z * narrow.y};
    }
    return geometry;
}

/// A cylinder around Z with its middle at `center`.
Geometry wheel(const glm::vec3& center, float radius, float width, int columns) {
    const glm::mat4 upright = glm::rotate(glm::mat4(1), glm::half_pi<float>(), {1, 0, 0});
    return translated(transformed(translated(cylinder(radius, width, columns), {0, -width / 2, 0}), upright), center);
}

} // namespace

StreetLamp streetLamp() {
    constexpr float kBend = 0.8f;
    StreetLamp out;
    const std::array<glm::vec3, 3> corners = {glm::vec3(0, 0.6f, 0), glm::vec3(0, kLampHeight + 0.15f, 0),
                                              glm::vec3(kLampReach + 0.3f, kLampHeight + 0.15f, 0)};
    const std::vector<glm::vec3> path = roundedPolyline(corners, kBend, 8);
    out.pole = tube(path, 0.055f, 12);
    constexpr std::array<glm::vec2, 7> kFoot = {
        {{0, 0}, {0.2f, 0}, {0.2f, 0.1f}, {0.13f, 0.18f}, {0.11f, 0.7f}, {0.07f, 0.78f}, {0, 0.78f}}};
    append(out.pole, lathe(kFoot, 20));
    append(out.pole, rounded({kLampReach, kLampHeight + 0.1f, 0}, {0.42f, 0.06f, 0.15f}, 0.05f, 2));
    out.head = rounded({kLampReach, kLampHeight + 0.03f, 0}, {0.34f, 0.025f, 0.11f}, 0.02f, 1);
    return out;
}

Car car() {
    Car out;
    out.body = rounded({0, 0.62f, 0}, {2.1f, 0.28f, 0.86f}, 0.2f, 3);
    append(out.body, rounded({-0.2f, 1.36f, 0}, {0.72f, 0.05f, 0.6f}, 0.045f, 2));
    append(out.body, rounded({0, 0.4f, 0}, {1.95f, 0.12f, 0.8f}, 0.08f, 2));
    out.windows =
        translated(tapered(roundedBox({1.35f, 0.3f, 0.78f}, 0.12f, 3), -0.3f, 0.3f, {0.56f, 0.82f}), {-0.2f, 1.08f, 0});
    for (const float x : {-1.3f, 1.3f}) {
        for (const float z : {-0.78f, 0.78f}) {
            append(out.tyres, wheel({x, 0.33f, z}, 0.33f, 0.2f, 32));
            append(out.rims, wheel({x, 0.33f, z}, 0.21f, 0.22f, 20));
        }
    }
    for (const float z : {-0.6f, 0.6f}) {
        append(out.headlamps, rounded({2.05f, 0.68f, z}, {0.08f, 0.08f, 0.17f}, 0.05f, 2));
        append(out.tailLamps, rounded({-2.05f, 0.72f, z}, {0.08f, 0.06f, 0.2f}, 0.04f, 2));
    }
    return out;
}

Tree tree(uint32_t seed) {
    constexpr float kTrunk = 2.6f;
    constexpr uint32_t kBranches = 9, kCards = 260;
    Tree out;
    const auto unit = [&](uint32_t i, uint32_t what) { return hashUnit(i, seed, what); };
    const std::array<glm::vec3, 3> trunk = {glm::vec3(0, 0, 0), glm::vec3(0.05f, kTrunk / 2, 0.03f),
                                            glm::vec3(0, kTrunk + 1.2f, 0)};
    out.trunk = tube(trunk, 0.11f, 12);
    for (uint32_t i = 0; i < kBranches; ++i) {
        const float angle = glm::two_pi<float>() * (static_cast<float>(i) + unit(i, 1)) / kBranches;
        const glm::vec3 from(0, kTrunk - 0.4f + 1.3f * unit(i, 2), 0);
        const glm::vec3 out1 = from + glm::vec3(0.7f * std::cos(angle), 0.5f, 0.7f * std::sin(angle));
        const std::array<glm::vec3, 3> branch = {
            from, out1, out1 + glm::vec3(0.4f * std::cos(angle), 0.6f, 0.4f * std::sin(angle))};
        append(out.trunk, tube(branch, 0.035f, 7));
    }
    for (uint32_t i = 0; i < kCards; ++i) {
        // In a ball that is denser outside.
        const float z = 2 * unit(i, 3) - 1, turn = glm::two_pi<float>() * unit(i, 4);
        const glm::vec3 d(std::sqrt(1 - z * z) * std::cos(turn), z, std::sqrt(1 - z * z) * std::sin(turn));
        const glm::vec3 center =
            glm::vec3(0, kTrunk + 1.5f, 0) + d * glm::vec3(1.5f, 1.35f, 1.5f) * std::cbrt(0.2f + 0.8f * unit(i, 5));
        const float around = glm::two_pi<float>() * unit(i, 6), tilt = unit(i, 7) - 0.5f;
        const glm::vec3 up = 0.4f * glm::normalize(glm::vec3(-tilt * std::sin(around), 1, tilt * std::cos(around)));
        glm::vec3 right = 0.4f * glm::vec3(std::cos(around), 0, std::sin(around));
        const glm::vec3 outward = glm::normalize(center - glm::vec3(0, kTrunk + 1, 0));
        if (glm::dot(glm::cross(right, up), outward) < 0)
            right = -right;
        appendQuad(out.leaves, {center - right - up, center + right - up, center + right + up, center - right + up},
                   {glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0), glm::vec2(0, 0)});
        std::fill(out.leaves.normals.end() - 4, out.leaves.normals.end(), outward); // lit as a ball, not as cards
    }
    return out;
}

Geometry bollard() {
    constexpr std::array<glm::vec2, 8> kProfile = {
        {{0, 0}, {0.12f, 0}, {0.12f, 0.08f}, {0.08f, 0.12f}, {0.07f, 0.85f}, {0.1f, 0.9f}, {0.06f, 1.0f}, {0, 1.02f}}};
    return lathe(kProfile, 24);
}

Geometry litterBin() {
    constexpr std::array<glm::vec2, 7> kProfile = {
        {{0, 0}, {0.24f, 0}, {0.27f, 0.8f}, {0.3f, 0.82f}, {0.28f, 0.95f}, {0.12f, 1.02f}, {0, 1.02f}}};
    return lathe(kProfile, 32);
}

Geometry hydrant() {
    constexpr std::array<glm::vec2, 10> kProfile = {{{0, 0},
                                                     {0.18f, 0},
                                                     {0.18f, 0.06f},
                                                     {0.12f, 0.08f},
                                                     {0.12f, 0.5f},
                                                     {0.16f, 0.53f},
                                                     {0.16f, 0.58f},
                                                     {0.12f, 0.62f},
                                                     {0.06f, 0.74f},
                                                     {0, 0.76f}}};
    Geometry out = lathe(kProfile, 24);
    append(out, wheel({0, 0.4f, 0}, 0.07f, 0.4f, 16));
    return out;
}

TrafficLight trafficLight() {
    TrafficLight out;
    out.housing = cylinder(0.06f, 3.2f, 12);
    append(out.housing, rounded({0, 2.75f, 0.12f}, {0.15f, 0.45f, 0.1f}, 0.03f, 1));
    const auto lens = [](float y) { return wheel({0, y, 0.22f}, 0.09f, 0.03f, 24); };
    out.red = lens(3.02f);
    out.amber = lens(2.75f);
    out.green = lens(2.48f);
    return out;
}

} // namespace glint::scene::builtin
