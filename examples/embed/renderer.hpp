// SPDX-License-Identifier: MIT
// The host's renderer, which knows nothing of Glint: a few shapes round a mirror pool, found by analytic intersection
// on the CPU, and the G-buffer that falls out of it. A real engine has these images on the GPU already.
//
// Its conventions are its own (main.cpp states them): depth grows from 0 at a near plane to 1 at a finite far plane,
// clip space has +Y down as plain Vulkan does, normals are in view space and stored as n * 0.5 + 0.5, and the material
// holds smoothness instead of roughness.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

struct Vec3 {
    float x = 0, y = 0, z = 0;
};
inline Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(Vec3 a, Vec3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec3 operator*(Vec3 a, float s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline float dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 normalize(Vec3 v) {
    return v * (1 / std::sqrt(dot(v, v)));
}
inline Vec3 reflect(Vec3 d, Vec3 n) {
    return d - n * (2 * dot(d, n));
}
inline Vec3 mix(Vec3 a, Vec3 b, float t) {
    return a * (1 - t) + b * t;
}

// ---------------------------------------------------------------- the scene

struct Material {
    Vec3 diffuse, f0; // f0: reflectance at normal incidence
    float smoothness = 0;
    Vec3 emission = {};
};
struct Sphere {
    Vec3 center;
    float radius;
    Material material;
};
struct Box {
    Vec3 low, high;
    Material material;
};
struct Hit {
    float distance = 1e9f;
    Vec3 normal;
    Material material;
};

constexpr Vec3 kPlastic = {0.04f, 0.04f, 0.04f};
constexpr float kPoolRadius = 4.3f;
const Material kGround = {{0.16f, 0.14f, 0.13f}, kPlastic, 0.1f};
const Material kMirror = {{}, {1, 1, 1}, 1};
const Box kStanding = {{2.3f, 0, 0.7f}, {2.36f, 1.5f, 2.0f}, kMirror};
const std::array<Sphere, 4> kSpheres = {{
    {{-1.3f, 0.5f, 0.5f}, 0.5f, {{0.62f, 0.05f, 0.04f}, kPlastic, 0.8f}},
    {{1.9f, 0.62f, -0.9f}, 0.62f, {{}, {0.95f, 0.74f, 0.40f}, 0.95f}},
    {{0.85f, 0.22f, 1.5f}, 0.22f, {{0.04f, 0.22f, 0.60f}, kPlastic, 0.7f}},
    {{-0.95f, 0.18f, 1.8f}, 0.18f, {{0.70f, 0.66f, 0.60f}, kPlastic, 0.5f}},
}};
const std::array<Box, 5> kBoxes = {{
    {{-2.4f, 0, -1.7f}, {-1.7f, 1.9f, -1.0f}, {{0.05f, 0.32f, 0.28f}, kPlastic, 0.4f}},
    {{-0.6f, 0, -2.6f}, {-0.1f, 2.4f, -2.1f}, {{0.30f, 0.12f, 0.38f}, kPlastic, 0.4f}},
    {{0.15f, 0, -1.4f}, {0.95f, 1.4f, -0.8f}, {{}, kPlastic, 0, {1.5f, 0.62f, 0.10f}}}, // glows in one flat colour
    kStanding,
    {{2.5f, 0, -1.4f}, {2.9f, 2.2f, -1.0f}, {{0.55f, 0.52f, 0.48f}, kPlastic, 0.3f}},
}};
const Vec3 kToSun = normalize({-0.7f, 0.5f, 0.6f});

inline Vec3 sky(Vec3 direction) {
    const float height = std::clamp(direction.y, 0.0f, 1.0f);
    return mix({0.62f, 0.40f, 0.29f}, {0.03f, 0.07f, 0.19f}, std::pow(height, 0.45f));
}

/// The nearest surface along a ray; false: the sky.
inline bool trace(Vec3 from, Vec3 direction, Hit& hit) {
    hit = {};
    if (direction.y < 0) {
        hit.distance = -from.y / direction.y;
        const Vec3 p = from + direction * hit.distance;
        hit.normal = {0, 1, 0};
        hit.material = p.x * p.x + p.z * p.z < kPoolRadius * kPoolRadius ? kMirror : kGround;
    }
    for (const Sphere& sphere : kSpheres) {
        const Vec3 toCenter = sphere.center - from;
        const float along = dot(toCenter, direction);
        const float inside = sphere.radius * sphere.radius - dot(toCenter, toCenter) + along * along;
        const float distance = along - std::sqrt(std::max(inside, 0.0f));
        if (inside > 0 && distance > 0 && distance < hit.distance) {
            const Vec3 p = from + direction * distance;
            hit = {distance, normalize(p - sphere.center), sphere.material};
        }
    }
    for (const Box& box : kBoxes) {
        const float o[] = {from.x, from.y, from.z}, d[] = {direction.x, direction.y, direction.z};
        const float low[] = {box.low.x, box.low.y, box.low.z}, high[] = {box.high.x, box.high.y, box.high.z};
        float enter = 0, leave = 1e9f;
        int axis = 0;
        for (int i = 0; i < 3; ++i) { // the ray's stretch between each pair of planes
            const float a = (low[i] - o[i]) / d[i], b = (high[i] - o[i]) / d[i];
            if (std::min(a, b) > enter) {
                enter = std::min(a, b);
                axis = i;
            }
            leave = std::min(leave, std::max(a, b));
        }
        if (enter > 0 && enter < leave && enter < hit.distance) {
            float n[3] = {};
            n[axis] = d[axis] < 0 ? 1.0f : -1.0f;
            hit = {enter, {n[0], n[1], n[2]}, box.material};
        }
    }
    return hit.distance < 1e9f;
}

// ---------------------------------------------------------------- the picture

using Matrix = std::array<float, 16>; // column-major

/// Everything that the host's lighting pass leaves behind, as a GPU would hold it.
struct Picture {
    uint32_t width = 0, height = 0;
    Matrix worldToView = {}, viewToClip = {};
    std::vector<float> depth;       // D32_SFLOAT_S8_UINT, [0, 1], 1 is far
    std::vector<uint16_t> normal;   // R16G16B16A16_UNORM, view space, n * 0.5 + 0.5
    std::vector<uint8_t> material;  // R8G8B8A8_UNORM, F0 and smoothness
    std::vector<float> lit;         // R32G32B32A32_SFLOAT, linear: the whole picture, sky reflections included
    std::vector<float> skySpecular; // R32G32B32A32_SFLOAT, linear: the sky reflections alone, without knowing occluders
    /// A pixel of the glowing box, and those in which the pool and the standing mirror must show it.
    std::array<uint32_t, 2> glowing = {}, inPool = {}, inMirror = {};
};

inline Picture render(uint32_t width, uint32_t height) {
    constexpr Vec3 kEye = {-1.1f, 0.9f, 5.6f};
    constexpr float kTurn = 0.19f, kNear = 0.1f, kFar = 60; // radians to the right; metres
    const float focal = 2.1f, aspect = static_cast<float>(width) / static_cast<float>(height);
    const Vec3 right = {std::cos(kTurn), 0, std::sin(kTurn)}, up = {0, 1, 0};
    const Vec3 back = {-std::sin(kTurn), 0, std::cos(kTurn)}; // view space looks down -Z

    Picture picture;
    picture.width = width, picture.height = height;
    picture.worldToView = {right.x, up.x, back.x, 0, right.y,           up.y,           back.y,           0,
                           right.z, up.z, back.z, 0, -dot(right, kEye), -dot(up, kEye), -dot(back, kEye), 1};
    picture.viewToClip = {focal / aspect,
                          0,
                          0,
                          0,
                          0,
                          -focal,
                          0,
                          0,
                          0,
                          0,
                          kFar / (kNear - kFar),
                          -1,
                          0,
                          0,
                          kNear * kFar / (kNear - kFar),
                          0};

    const auto unorm = [](float v, float top) { return std::clamp(v, 0.0f, 1.0f) * top + 0.5f; };
    const auto append = [](std::vector<float>& image, Vec3 c) { image.insert(image.end(), {c.x, c.y, c.z, 1}); };
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const float ndcX = (2 * static_cast<float>(x) + 1) / static_cast<float>(width) - 1;
            const float ndcY = (2 * static_cast<float>(y) + 1) / static_cast<float>(height) - 1;
            const Vec3 direction = normalize(right * (ndcX * aspect / focal) - up * (ndcY / focal) - back);
            Hit hit;
            float depth = 1; // the far plane: nothing was drawn
            Vec3 normal = {0, 0, 1}, lit = sky(direction), specular = {};
            if (trace(kEye, direction, hit)) {
                const float viewZ = -dot(direction * hit.distance, back);
                if (viewZ < kFar)
                    depth = kFar / (kFar - kNear) * (1 - kNear / viewZ);
                const Material& m = hit.material;
                normal = {dot(hit.normal, right), dot(hit.normal, up), dot(hit.normal, back)};
                Hit blocker;
                const Vec3 p = kEye + direction * hit.distance + hit.normal * 1e-3f;
                const float sun = trace(p, kToSun, blocker) ? 0 : std::max(dot(hit.normal, kToSun), 0.0f);
                const Vec3 light =
                    Vec3{2.0f, 1.35f, 0.85f} * sun + Vec3{0.22f, 0.22f, 0.28f} * (0.6f + 0.4f * hit.normal.y);
                specular = m.f0 * sky(reflect(direction, hit.normal));
                lit = m.emission + m.diffuse * light + specular;
                const float haze = 1 - std::exp(-std::max(viewZ - 12, 0.0f) / 12); // hides the horizon's edge
                lit = mix(lit, sky({0, 0, 0}), haze);
                specular = specular * (1 - haze);
            }
            picture.depth.push_back(depth);
            for (const float n : {normal.x, normal.y, normal.z, 1.0f})
                picture.normal.push_back(static_cast<uint16_t>(unorm(n * 0.5f + 0.5f, 65535)));
            for (const float c : {hit.material.f0.x, hit.material.f0.y, hit.material.f0.z, hit.material.smoothness})
                picture.material.push_back(static_cast<uint8_t>(unorm(c, 255)));
            append(picture.lit, lit);
            append(picture.skySpecular, specular);
        }

    // A flat mirror shows a point where it would stand if it were as far behind the mirror as it is before it.
    const auto pixelOf = [&](Vec3 p) {
        const Vec3 toPoint = p - kEye;
        const float viewZ = -dot(toPoint, back);
        const float ndcX = focal / aspect * dot(toPoint, right) / viewZ, ndcY = -focal * dot(toPoint, up) / viewZ;
        return std::array<uint32_t, 2>{static_cast<uint32_t>((ndcX * 0.5f + 0.5f) * static_cast<float>(width)),
                                       static_cast<uint32_t>((ndcY * 0.5f + 0.5f) * static_cast<float>(height))};
    };
    const Vec3 point = {0.55f, 0.75f, -0.8f}; // on the face of the glowing box
    picture.glowing = pixelOf(point);
    picture.inPool = pixelOf({point.x, -point.y, point.z});
    picture.inMirror = pixelOf({2 * kStanding.low.x - point.x, point.y, point.z});
    return picture;
}
