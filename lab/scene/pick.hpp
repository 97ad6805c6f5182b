// The surface that a ray hits first, on the CPU: for a click in a window.
#pragma once

#include "lab/scene/pose.hpp"

#include <cstddef>
#include <optional>

namespace glint::scene {

/// Returns the index of the item of `pose` whose triangles the ray hits first, from either side; alpha-tested holes
/// count as surface. Cost: visits every triangle.
std::optional<size_t> pickItem(const Pose& pose, const glm::vec3& originWS, const glm::vec3& directionWS);

/// Origin and direction, unit, of the ray through a point of a camera's image; (0, 0) is its top left.
struct CameraRay {
    glm::vec3 originWS;
    glm::vec3 directionWS;
};
CameraRay cameraRay(const Camera& camera, const glm::vec2& uv, float aspectRatio);

} // namespace glint::scene
