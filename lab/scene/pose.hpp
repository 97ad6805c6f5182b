// A scene at one time: animations sampled, skins and morph targets applied, the tree flattened into a list.
#pragma once

#include "base/result.hpp"
#include "lab/scene/camera.hpp"
#include "lab/scene/scene.hpp"

#include <memory>
#include <vector>

namespace glint::scene {

struct Bounds {
    glm::vec3 min = glm::vec3(std::numeric_limits<float>::max());
    glm::vec3 max = glm::vec3(std::numeric_limits<float>::lowest());
    bool empty() const { return min.x > max.x; }
    glm::vec3 center() const { return min * 0.5f + max * 0.5f; }
};

struct DrawItem {
    const Geometry* geometry = nullptr; ///< of the Scene, or of Pose::deformed
    int material = -1;
    int node = -1;
    glm::mat4 localToWorld = glm::mat4(1); ///< identity for skinned geometry, which is posed in world space
    Bounds boundsWS;                       ///< never empty
};

struct PosedLight {
    Light light;
    glm::vec3 positionWS = glm::vec3(0);
    glm::vec3 directionWS = glm::vec3(0, 0, -1); ///< unit, the direction in which the light travels
};

/// Refers to the Scene that it was made from, which must outlive it.
struct Pose {
    std::vector<DrawItem> items;
    std::vector<PosedLight> lights;
    std::vector<Camera> cameras; ///< the file's cameras, in node order
    std::vector<std::unique_ptr<Geometry>> deformed;
    Bounds boundsWS; ///< of all items; empty if there are none
};

/// Samples every animation at `time` seconds (clamped to each channel's own range) and flattens scene `sceneIndex` (-1:
/// the default scene). Errors: InvalidArgument for a scene that does not exist.
Result<Pose> pose(const Scene& scene, double time, int sceneIndex = -1);

} // namespace glint::scene
