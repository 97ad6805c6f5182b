// A camera controlled by the user: it orbits around a point, pans, dollies, or flies.
#pragma once

#include "lab/scene/camera.hpp"

#include <string>

namespace glint::view {

/// Looks from `position()` to `target()`, +Y up. A scene's camera is used unchanged, rolled or not, until the user
/// first moves it.
class OrbitCamera {
public:
    OrbitCamera() = default;
    /// `distance`  metres to the orbit target, > 0
    OrbitCamera(const scene::Camera& camera, float distance);

    /// Orbits around the target as if the user turned the scene: its near side moves by these radians to the right and
    /// up. Stops short of straight up and down.
    void orbit(float right, float up);
    /// Rotates around the camera's own position.
    void look(float right, float up);
    /// Moves in the image plane, to the right and up, in units of the image height at the target's distance.
    void pan(float right, float up);
    /// Multiplies the distance to the target by this factor: (0, 1) moves closer, (1, inf) farther away. The target
    /// does not move.
    void dolly(float factor);
    /// Moves by metres to the right, up and ahead, in the camera's own axes; the target moves along.
    void fly(const glm::vec3& rightUpAhead);
    /// Turns towards a point, which becomes the target. The position does not change.
    void focus(const glm::vec3& pointWS);
    /// Follows an animated scene camera; has no effect once the user has moved the camera.
    void follow(const scene::Camera& camera);

    /// Becomes exactly this camera, which was read back from a file with rounded numbers. Counts as moved.
    void settle(const scene::Camera& camera);

    const scene::Camera& camera() const { return camera_; }
    glm::vec3 position() const { return glm::vec3(camera_.viewToWorld[3]); }
    glm::vec3 target() const { return target_; }
    float distance() const { return glm::length(target_ - position()); }
    bool moved() const { return moved_; } ///< by the user

    /// Returns the camera as a camera file (scene::readCameraFile), for images of this size.
    std::string json(uint32_t width, uint32_t height) const;

private:
    glm::vec3 ahead() const { return -glm::vec3(camera_.viewToWorld[2]); }
    void place(const glm::vec3& position, const glm::vec3& target);

    scene::Camera camera_;
    glm::vec3 target_ = glm::vec3(0, 0, -1);
    bool moved_ = false;
};

/// True if all bits are equal.
bool sameCamera(const scene::Camera& a, const scene::Camera& b);

} // namespace glint::view
