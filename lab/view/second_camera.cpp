#include "lab/view/second_camera.hpp"

#include "lab/view/ray_lines.hpp"

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

constexpr float kRight = -0.7f, kUp = -0.3f; ///< radians about the target, from the inspecting camera
constexpr float kBack = 1.3f;                ///< times the inspecting camera's distance, or the ray's length
constexpr uint32_t kPlaces = 12;             ///< candidate pixels per image axis
constexpr uint32_t kShares = 5;              ///< candidates on the way to each pixel's surface
constexpr float kTolerance = 0.01f;          ///< of the depth: rays start and end on surfaces

/// Returns the share of the line between two points that the inspecting camera sees unoccluded, (0, 1].
float openShare(const render::View& asked, std::span<const float> depth, const glm::vec3& a, const glm::vec3& b) {
    constexpr int kSteps = 16;
    int open = 1;
    for (int i = 1; i < kSteps; ++i) {
        const Seen seen = seenFrom(asked, a + (b - a) * (static_cast<float>(i) / kSteps));
        const bool inside = seen.depth > 0 && glm::all(glm::greaterThanEqual(seen.px, glm::vec2(0))) &&
                            glm::all(glm::lessThan(seen.px, glm::vec2(asked.width, asked.height)));
        if (inside)
            open += seen.depth < depth[static_cast<size_t>(seen.px.y) * asked.width + static_cast<size_t>(seen.px.x)];
    }
    return static_cast<float>(open) / kSteps;
}

} // namespace

void SecondCamera::lookAt(const OrbitCamera& asking) {
    camera = OrbitCamera(asking.camera(), asking.distance());
    camera.orbit(kRight, kUp);
    camera.dolly(kBack);
    placed = true;
    turned = false;
}

void SecondCamera::lookAt(const RayInspection& ray, const render::View& asked, std::span<const float> askedDepth,
                          const scene::Camera& asking) {
    const auto vec = [](const Float3& v) { return glm::vec3(v[0], v[1], v[2]); };
    const glm::vec3 start = vec(ray.positionWS);
    // Without a ray, show the line from the pixel's surface to the camera.
    const glm::vec3 line = ray.traced ? vec(ray.end.positionWS) - start : asked.positionWS() - start;
    const glm::vec3 middle = start + line * 0.5f;
    const float length = std::max(glm::length(line), 1e-3f);
    scene::Camera lens = asking;
    float best = -1;
    for (uint32_t i = 0; i < kPlaces * kPlaces * kShares; ++i) {
        const glm::uvec2 cell(i % kPlaces, i / kPlaces % kPlaces);
        const glm::uvec2 px = (cell * 2u + 1u) * glm::uvec2(asked.width, asked.height) / (2 * kPlaces);
        const float open = std::min(askedDepth[px.y * asked.width + px.x], 4 * length);
        const uint32_t step = i / (kPlaces * kPlaces);
        const float share = static_cast<float>(step) / kShares; // 0: at the inspecting camera
        const glm::vec3 place = pointAt(asked, glm::vec2(px) + 0.5f, std::max(open * share * 0.9f, 1e-3f));
        const glm::vec3 sight = middle - place;
        const float far = std::max(glm::length(sight), 1e-3f);
        const float across = glm::length(glm::cross(sight / far, line / length));
        const float fits = std::exp(-std::abs(std::log(far / (kBack * length))));
        float worth = across * fits;
        if (worth <= best)
            continue;
        for (const glm::vec3& end : {start, start + line}) // prefer both in view
            if (glm::dot(glm::normalize(end - place), sight / far) < std::cos(asking.fovY * 0.45f))
                worth *= 0.25f;
        for (const float at : {0.05f, 0.3f, 0.6f, 0.95f})
            worth *= openShare(asked, askedDepth, place, start + line * at);
        if (worth > best) {
            best = worth;
            lens.viewToWorld = scene::lookAt(place, middle);
            camera = OrbitCamera(lens, far);
        }
    }
    placed = true;
    turned = false;
}

bool SecondCamera::hides(glm::vec2 px, float metres) const {
    if (depth.empty() || px.x < 0 || px.y < 0 || px.x >= static_cast<float>(view.width) ||
        px.y >= static_cast<float>(view.height))
        return false;
    const float seen = depth[static_cast<size_t>(px.y) * view.width + static_cast<size_t>(px.x)];
    return metres > seen * (1 + kTolerance);
}

} // namespace glint::view
