// Traces lists of rays through a RayScene, and has an oracle that tests every triangle in double precision.
#pragma once

#include "gpu/support/gpu_test.hpp"
#include "rays/scene.hpp"
#include "shared/ray_flags.h"

#include <glm/glm.hpp>

namespace glint::test {

/// Layout of lib/ray.glsl's Ray, in scalar layout.
struct TestRay {
    glm::vec3 originWS = glm::vec3(0);
    float tMin = 0;
    glm::vec3 directionWS = glm::vec3(0, 0, -1);
    float tMax = 1e24f;
    uint32_t mask = 0xff;
    uint32_t flags = 0;
};

/// Layout of tests/gpu/shaders/ray_main.glsl's output.
struct TestHit {
    float distance = 0;
    uint32_t instance = shared::kNoInstance;
    uint32_t primitive = 0;
    glm::vec2 barycentrics = glm::vec2(0);
    uint32_t frontFace = 0;
    uint32_t occluded = 0;
    bool met() const { return instance != shared::kNoInstance; }
};

/// A mesh that owns its vertices.
struct TestMesh {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices;
    bool deforms = false;
    std::vector<glm::vec4> colors; ///< of the vertices, for surfaces; empty: white

    void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
    RayMesh view() const {
        return {positions.empty() ? nullptr : &positions.front().x, static_cast<uint32_t>(positions.size()),
                sizeof(glm::vec3), indices, deforms};
    }
};

struct TestScene {
    std::vector<TestMesh> meshes;
    std::vector<RayInstance> instances;

    std::unique_ptr<rays::Scene> build(gpu::Context& context, RayBackend backend, uint32_t maxInstances = 0) const;
};

/// One triangle at z = -2 that faces +Z; the default TestRay hits it.
TestScene oneTriangle();

/// Records pending work and traces; also frees the staging memory. `milliseconds`: GPU time of both the nearest hits
/// and the occlusion tests; 0 without timestamps.
std::vector<TestHit> traceRays(gpu::Context& context, rays::Scene& scene, const std::vector<TestRay>& rays,
                               double* milliseconds = nullptr);

/// Every hit of a ray on the scene, in double precision: nearest first. Alpha holes as in
/// tests/gpu/shaders/ray_alpha.glsl.
struct ExactHit {
    double distance = 0;
    uint32_t instance = 0;
    uint32_t primitive = 0;
    glm::dvec2 barycentrics = glm::dvec2(0);
    bool frontFace = true;
    double edge = 0; ///< smallest of the three weights: how far inside the triangle the hit is
};
std::vector<ExactHit> exactHits(const TestScene& scene, const TestRay& ray);

} // namespace glint::test
