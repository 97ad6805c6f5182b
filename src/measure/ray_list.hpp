// Rays that are timed by the list, and their hits: those of a camera, which go side by side, and those that leave a
// surface in any direction.
#pragma once

#include "measure/ray_bench_scene.hpp"
#include "shared/ray_flags.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace glint::measure {

/// As lib/ray.glsl has it, in scalar layout.
struct ListedRay {
    glm::vec3 originWS = glm::vec3(0);
    float tMin = 0;
    glm::vec3 directionWS = glm::vec3(0, 0, -1);
    float tMax = 1e24f;
    uint32_t mask = 0xff;
    uint32_t flags = shared::kRayCullBackFaces;
};

/// As lib/ray.glsl has it, in scalar layout.
struct ListedHit {
    float distance = 0;
    uint32_t instance = shared::kNoInstance;
    uint32_t primitive = 0;
    glm::vec2 barycentrics = glm::vec2(0);
    uint32_t frontFace = 0;
    bool met() const { return instance != shared::kNoInstance; }
};

/// Of a square picture of the scene, about `count` pixels in tiles of 8 x 8, a work group each.
std::vector<ListedRay> cameraRays(uint32_t count);

/// As many rays as there are in `rays`, on from where those met the scene of phase 0: diffuse, by the cosine to the
/// triangle's normal. In the order of the hits, as a renderer has them; empty where nothing was met.
std::vector<ListedRay> bounceRays(const RayBenchScene& scene, std::span<const ListedRay> rays,
                                  std::span<const ListedHit> hits);

/// Hits against misses, or distances more than 1e-4 apart, and what a driver may lose of the origin besides.
uint64_t differingHits(std::span<const ListedRay> rays, std::span<const ListedHit> a, std::span<const ListedHit> b);

} // namespace glint::measure
