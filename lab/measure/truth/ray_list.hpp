// Lists of rays to time, and their hits: coherent camera rays, and rays that leave a surface in random directions.
#pragma once

#include "lab/measure/bench/ray_bench_scene.hpp"
#include "shared/ray_flags.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace glint::measure {

/// As in lib/ray.glsl, in scalar layout.
struct ListedRay {
    glm::vec3 originWS = glm::vec3(0);
    float tMin = 0;
    glm::vec3 directionWS = glm::vec3(0, 0, -1);
    float tMax = 1e24f;
    uint32_t mask = 0xff;
    uint32_t flags = shared::kRayCullBackFaces;
};

/// As in lib/ray.glsl, in scalar layout.
struct ListedHit {
    float distance = 0;
    uint32_t instance = shared::kNoInstance;
    uint32_t primitive = 0;
    glm::vec2 barycentrics = glm::vec2(0);
    uint32_t frontFace = 0;
    bool met() const { return instance != shared::kNoInstance; }
};

/// Returns the rays of a square image of the scene: about `count` pixels in tiles of 8 x 8, one workgroup each.
std::vector<ListedRay> cameraRays(uint32_t count);

/// Returns as many rays as `rays`, starting where those hit the scene of phase 0. Directions are cosine-distributed
/// around the triangle's normal. In the order of the hits, as in a renderer; empty where nothing was hit.
std::vector<ListedRay> bounceRays(const RayBenchScene& scene, std::span<const ListedRay> rays,
                                  std::span<const ListedHit> hits);

/// Counts rays where one back end hits and the other misses, or where distances differ by more than 1e-4 plus the
/// precision that a driver may lose at the origin.
uint64_t differingHits(std::span<const ListedRay> rays, std::span<const ListedHit> a, std::span<const ListedHit> b);

} // namespace glint::measure
