#include "lab/scene/pick.hpp"

#include <cmath>

namespace glint::scene {
namespace {

/// Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection". Returns metres along the ray;
/// infinity: no hit.
float triangleDistance(const glm::vec3& origin, const glm::vec3& direction, const glm::vec3& a, const glm::vec3& b,
                       const glm::vec3& c) {
    constexpr float kNone = std::numeric_limits<float>::infinity();
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 p = glm::cross(direction, ac);
    const float determinant = glm::dot(ab, p);
    if (determinant == 0)
        return kNone;
    const glm::vec3 toOrigin = origin - a;
    const float u = glm::dot(toOrigin, p) / determinant;
    const glm::vec3 q = glm::cross(toOrigin, ab);
    const float v = glm::dot(direction, q) / determinant;
    const float distance = glm::dot(ac, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 ? distance : kNone;
}

} // namespace

std::optional<size_t> pickItem(const Pose& pose, const glm::vec3& originWS, const glm::vec3& directionWS) {
    float nearest = std::numeric_limits<float>::infinity();
    std::optional<size_t> picked;
    for (size_t i = 0; i < pose.items.size(); ++i) {
        const DrawItem& item = pose.items[i];
        const Geometry& g = *item.geometry;
        if (g.topology != Topology::Triangles)
            continue;
        // An affine transform keeps distances along the ray, if its direction is not normalized.
        const glm::mat4 worldToLocal = glm::inverse(item.localToWorld);
        const glm::vec3 origin(worldToLocal * glm::vec4(originWS, 1));
        const glm::vec3 direction(worldToLocal * glm::vec4(directionWS, 0));
        for (size_t corner = 0; corner + 2 < g.indices.size(); corner += 3) {
            const float distance =
                triangleDistance(origin, direction, g.positions[g.indices[corner]], g.positions[g.indices[corner + 1]],
                                 g.positions[g.indices[corner + 2]]);
            if (distance < nearest) {
                nearest = distance;
                picked = i;
            }
        }
    }
    return picked;
}

CameraRay cameraRay(const Camera& camera, const glm::vec2& uv, float aspectRatio) {
    const glm::vec2 ndc(2 * uv.x - 1, 1 - 2 * uv.y);
    const glm::mat4& toWorld = camera.viewToWorld;
    const float height = camera.orthographic ? camera.orthoHeight / 2 : std::tan(camera.fovY / 2);
    const glm::vec3 place(ndc.x * height * aspectRatio, ndc.y * height, -1);
    if (camera.orthographic)
        return {glm::vec3(toWorld * glm::vec4(place.x, place.y, 0, 1)), -glm::vec3(toWorld[2])};
    return {glm::vec3(toWorld[3]), glm::normalize(glm::vec3(toWorld * glm::vec4(place, 0)))};
}

} // namespace glint::scene
