// SPDX-License-Identifier: MIT
// The host's renderer, which knows nothing of Glint: the scene and the G-buffer of examples/embed/renderer.hpp in C,
// the same numbers to the last bit. A real engine has these images on the GPU already.
#pragma once

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct Vec3 {
    float x, y, z;
} Vec3;

static Vec3 vec3(float x, float y, float z) {
    const Vec3 v = {x, y, z};
    return v;
}
static Vec3 add(Vec3 a, Vec3 b) {
    return vec3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static Vec3 subtract(Vec3 a, Vec3 b) {
    return vec3(a.x - b.x, a.y - b.y, a.z - b.z);
}
static Vec3 multiply(Vec3 a, Vec3 b) {
    return vec3(a.x * b.x, a.y * b.y, a.z * b.z);
}
static Vec3 scale(Vec3 a, float s) {
    return vec3(a.x * s, a.y * s, a.z * s);
}
static float dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static Vec3 normalize(Vec3 v) {
    return scale(v, 1 / sqrtf(dot(v, v)));
}
static Vec3 reflect(Vec3 d, Vec3 n) {
    return subtract(d, scale(n, 2 * dot(d, n)));
}
static Vec3 mix(Vec3 a, Vec3 b, float t) {
    return add(scale(a, 1 - t), scale(b, t));
}
static float atLeast(float v, float least) {
    return v < least ? least : v;
}
static float clamp(float v, float low, float high) {
    return v < low ? low : v > high ? high : v;
}

// ---------------------------------------------------------------- the scene

typedef struct Material {
    Vec3 diffuse, f0; // f0: reflectance at normal incidence
    float smoothness;
    Vec3 emission;
} Material;
typedef struct Sphere {
    Vec3 center;
    float radius;
    Material material;
} Sphere;
typedef struct Box {
    float low[3], high[3];
    Material material;
} Box;
typedef struct Hit {
    float distance;
    Vec3 normal;
    Material material;
} Hit;

#define PLASTIC                                                                                                        \
    { 0.04f, 0.04f, 0.04f }
#define MIRROR                                                                                                         \
    {                                                                                                                  \
        {0, 0, 0}, {1, 1, 1}, 1, {                                                                                     \
            0, 0, 0                                                                                                    \
        }                                                                                                              \
    }
static const float poolRadius = 4.3f;
static const Material ground = {{0.16f, 0.14f, 0.13f}, PLASTIC, 0.1f, {0, 0, 0}};
static const Material mirror = MIRROR;
static const Sphere spheres[4] = {
    {{-1.3f, 0.5f, 0.5f}, 0.5f, {{0.62f, 0.05f, 0.04f}, PLASTIC, 0.8f, {0, 0, 0}}},
    {{1.9f, 0.62f, -0.9f}, 0.62f, {{0, 0, 0}, {0.95f, 0.74f, 0.40f}, 0.95f, {0, 0, 0}}},
    {{0.85f, 0.22f, 1.5f}, 0.22f, {{0.04f, 0.22f, 0.60f}, PLASTIC, 0.7f, {0, 0, 0}}},
    {{-0.95f, 0.18f, 1.8f}, 0.18f, {{0.70f, 0.66f, 0.60f}, PLASTIC, 0.5f, {0, 0, 0}}},
};
static const Box boxes[5] = {
    {{-2.4f, 0, -1.7f}, {-1.7f, 1.9f, -1.0f}, {{0.05f, 0.32f, 0.28f}, PLASTIC, 0.4f, {0, 0, 0}}},
    {{-0.6f, 0, -2.6f}, {-0.1f, 2.4f, -2.1f}, {{0.30f, 0.12f, 0.38f}, PLASTIC, 0.4f, {0, 0, 0}}},
    {{0.15f, 0, -1.4f}, {0.95f, 1.4f, -0.8f}, {{0, 0, 0}, PLASTIC, 0, {1.5f, 0.62f, 0.10f}}}, // glows, one flat colour
    {{2.3f, 0, 0.7f}, {2.36f, 1.5f, 2.0f}, MIRROR},
    {{2.5f, 0, -1.4f}, {2.9f, 2.2f, -1.0f}, {{0.55f, 0.52f, 0.48f}, PLASTIC, 0.3f, {0, 0, 0}}},
};

static Vec3 toSun(void) {
    return normalize(vec3(-0.7f, 0.5f, 0.6f));
}

static Vec3 sky(Vec3 direction) {
    const float height = clamp(direction.y, 0, 1);
    return mix(vec3(0.62f, 0.40f, 0.29f), vec3(0.03f, 0.07f, 0.19f), powf(height, 0.45f));
}

// The nearest surface along a ray; false: the sky.
static bool trace(Vec3 from, Vec3 direction, Hit* hit) {
    const Hit none = {1e9f, {0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, 0, {0, 0, 0}}};
    *hit = none;
    if (direction.y < 0) {
        hit->distance = -from.y / direction.y;
        const Vec3 p = add(from, scale(direction, hit->distance));
        hit->normal = vec3(0, 1, 0);
        hit->material = p.x * p.x + p.z * p.z < poolRadius * poolRadius ? mirror : ground;
    }
    for (int s = 0; s < 4; ++s) {
        const Sphere* sphere = &spheres[s];
        const Vec3 toCenter = subtract(sphere->center, from);
        const float along = dot(toCenter, direction);
        const float inside = sphere->radius * sphere->radius - dot(toCenter, toCenter) + along * along;
        const float distance = along - sqrtf(atLeast(inside, 0));
        if (inside > 0 && distance > 0 && distance < hit->distance) {
            const Vec3 p = add(from, scale(direction, distance));
            hit->distance = distance;
            hit->normal = normalize(subtract(p, sphere->center));
            hit->material = sphere->material;
        }
    }
    for (int k = 0; k < 5; ++k) {
        const Box* box = &boxes[k];
        const float o[3] = {from.x, from.y, from.z}, d[3] = {direction.x, direction.y, direction.z};
        float enter = 0, leave = 1e9f;
        int axis = 0;
        for (int i = 0; i < 3; ++i) { // the ray's stretch between each pair of planes
            const float a = (box->low[i] - o[i]) / d[i], b = (box->high[i] - o[i]) / d[i];
            const float near = b < a ? b : a, far = a < b ? b : a;
            if (near > enter) {
                enter = near;
                axis = i;
            }
            leave = far < leave ? far : leave;
        }
        if (enter > 0 && enter < leave && enter < hit->distance) {
            float n[3] = {0, 0, 0};
            n[axis] = d[axis] < 0 ? 1.0f : -1.0f;
            hit->distance = enter;
            hit->normal = vec3(n[0], n[1], n[2]);
            hit->material = box->material;
        }
    }
    return hit->distance < 1e9f;
}

// ---------------------------------------------------------------- the picture

// Everything that the host's lighting pass leaves behind, as a GPU would hold it.
typedef struct Picture {
    uint32_t width, height;
    float worldToView[16], viewToClip[16]; // column-major
    float* depth;                          // D32_SFLOAT_S8_UINT, [0, 1], 1 is far
    uint16_t* normal;                      // R16G16B16A16_UNORM, view space, n * 0.5 + 0.5
    uint8_t* material;                     // R8G8B8A8_UNORM, F0 and smoothness
    float* lit;                            // R32G32B32A32_SFLOAT, linear: the whole picture, sky reflections included
    float* skySpecular;                    // R32G32B32A32_SFLOAT, linear: the sky reflections alone
} Picture;

static float unorm(float v, float top) {
    return clamp(v, 0, 1) * top + 0.5f;
}
static void putColor(float* image, size_t pixel, Vec3 c) {
    image[4 * pixel] = c.x, image[4 * pixel + 1] = c.y, image[4 * pixel + 2] = c.z, image[4 * pixel + 3] = 1;
}

static Picture render(uint32_t width, uint32_t height) {
    const Vec3 eye = {-1.1f, 0.9f, 5.6f};
    const float turn = 0.19f, nearPlane = 0.1f, farPlane = 60; // radians to the right; metres
    const float focal = 2.1f, aspect = (float)width / (float)height;
    const Vec3 right = {cosf(turn), 0, sinf(turn)}, up = {0, 1, 0};
    const Vec3 back = {-sinf(turn), 0, cosf(turn)}; // view space looks down -Z

    const size_t pixels = (size_t)width * height;
    Picture picture = {
        width,
        height,
        {right.x, up.x, back.x, 0, right.y, up.y, back.y, 0, right.z, up.z, back.z, 0, -dot(right, eye), -dot(up, eye),
         -dot(back, eye), 1},
        {focal / aspect, 0, 0, 0, 0, -focal, 0, 0, 0, 0, farPlane / (nearPlane - farPlane), -1, 0, 0,
         nearPlane * farPlane / (nearPlane - farPlane), 0},
        malloc(pixels * sizeof(float)),
        malloc(pixels * 4 * sizeof(uint16_t)),
        malloc(pixels * 4),
        malloc(pixels * 4 * sizeof(float)),
        malloc(pixels * 4 * sizeof(float)),
    };
    if (!picture.depth || !picture.normal || !picture.material || !picture.lit || !picture.skySpecular)
        abort();

    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const size_t pixel = (size_t)y * width + x;
            const float ndcX = (2 * (float)x + 1) / (float)width - 1;
            const float ndcY = (2 * (float)y + 1) / (float)height - 1;
            const Vec3 direction =
                normalize(subtract(subtract(scale(right, ndcX * aspect / focal), scale(up, ndcY / focal)), back));
            Hit hit;
            float depth = 1; // the far plane: nothing was drawn
            Vec3 normal = {0, 0, 1}, lit = sky(direction), specular = {0, 0, 0};
            if (trace(eye, direction, &hit)) {
                const float viewZ = -dot(scale(direction, hit.distance), back);
                if (viewZ < farPlane)
                    depth = farPlane / (farPlane - nearPlane) * (1 - nearPlane / viewZ);
                const Material* m = &hit.material;
                normal = vec3(dot(hit.normal, right), dot(hit.normal, up), dot(hit.normal, back));
                Hit blocker;
                const Vec3 p = add(add(eye, scale(direction, hit.distance)), scale(hit.normal, 1e-3f));
                const float sun = trace(p, toSun(), &blocker) ? 0 : atLeast(dot(hit.normal, toSun()), 0);
                const Vec3 light = add(scale(vec3(2.0f, 1.35f, 0.85f), sun),
                                       scale(vec3(0.22f, 0.22f, 0.28f), 0.6f + 0.4f * hit.normal.y));
                specular = multiply(m->f0, sky(reflect(direction, hit.normal)));
                lit = add(add(m->emission, multiply(m->diffuse, light)), specular);
                const float haze = 1 - expf(-atLeast(viewZ - 12, 0) / 12); // hides the horizon's edge
                lit = mix(lit, sky(vec3(0, 0, 0)), haze);
                specular = scale(specular, 1 - haze);
            }
            picture.depth[pixel] = depth;
            const float n[4] = {normal.x, normal.y, normal.z, 1};
            const float m[4] = {hit.material.f0.x, hit.material.f0.y, hit.material.f0.z, hit.material.smoothness};
            for (int i = 0; i < 4; ++i) {
                picture.normal[4 * pixel + (size_t)i] = (uint16_t)unorm(n[i] * 0.5f + 0.5f, 65535);
                picture.material[4 * pixel + (size_t)i] = (uint8_t)unorm(m[i], 255);
            }
            putColor(picture.lit, pixel, lit);
            putColor(picture.skySpecular, pixel, specular);
        }
    return picture;
}

static void freePicture(Picture* picture) {
    free(picture->depth);
    free(picture->normal);
    free(picture->material);
    free(picture->lit);
    free(picture->skySpecular);
}
