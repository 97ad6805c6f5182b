// The camera in a person's hands: it turns about a point, slides, comes closer, or flies.
#pragma once

#include "scene/camera.hpp"

#include <string>

namespace glint::view {

/// Looks from `position()` to `target()`, +Y up. A camera of the scene is shown exactly as it is, rolled or not, until
/// it is moved by hand for the first time.
class OrbitCamera {
public:
    OrbitCamera() = default;
    /// `distance`  metres to what the camera is to turn about, > 0
    OrbitCamera(const scene::Camera& camera, float distance);

    /// Turns about the target as if the scene were in the hand: its near side goes so many radians to the right and up.
    /// Stops short of straight up and down.
    void orbit(float right, float up);
    /// Turns about its own place, as a head does.
    void look(float right, float up);
    /// Slides in the picture's plane: in heights of the picture at the target's distance, to the right and up.
    void pan(float right, float up);
    /// Comes closer to the target by this factor, (0, 1), or farther away, (1, inf). The target stays where it is.
    void dolly(float factor);
    /// Flies: metres to the right, up and ahead, in the camera's own axes; the target comes along.
    void fly(const glm::vec3& rightUpAhead);
    /// Turns to a point, about which it turns from then on, and stays as far away as it is.
    void focus(const glm::vec3& pointWS);
    /// Shows a scene's camera that moves by itself; does nothing once it was moved by hand.
    void follow(const scene::Camera& camera);

    /// Becomes exactly this camera, which is what a file made of it: its numbers are rounded. Counts as moved.
    void settle(const scene::Camera& camera);

    const scene::Camera& camera() const { return camera_; }
    glm::vec3 position() const { return glm::vec3(camera_.viewToWorld[3]); }
    glm::vec3 target() const { return target_; }
    float distance() const { return glm::length(target_ - position()); }
    bool moved() const { return moved_; } ///< by hand

    /// As a camera file (scene::readCameraFile), for pictures of this size.
    std::string json(uint32_t width, uint32_t height) const;

private:
    glm::vec3 ahead() const { return -glm::vec3(camera_.viewToWorld[2]); }
    void place(const glm::vec3& position, const glm::vec3& target);

    scene::Camera camera_;
    glm::vec3 target_ = glm::vec3(0, 0, -1);
    bool moved_ = false;
};

/// To the bit.
bool sameCamera(const scene::Camera& a, const scene::Camera& b);

} // namespace glint::view
