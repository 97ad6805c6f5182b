#include "lab/view/orbit_camera.hpp"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

constexpr float kSteepest = glm::radians(89.0f); ///< limit of the elevation
constexpr float kNearest = 1e-3f;                ///< metres to the target

struct Angles {
    float azimuth = 0;   ///< radians about +Y from -Z, to the right
    float elevation = 0; ///< radians above the horizon
};

Angles anglesOf(const glm::vec3& direction) {
    return {std::atan2(direction.x, -direction.z), std::asin(std::clamp(direction.y, -1.0f, 1.0f))};
}

glm::vec3 directionOf(const Angles& angles) {
    const float level = std::cos(angles.elevation);
    return {std::sin(angles.azimuth) * level, std::sin(angles.elevation), -std::cos(angles.azimuth) * level};
}

glm::vec3 turned(const glm::vec3& direction, float right, float up) {
    Angles angles = anglesOf(direction);
    angles.azimuth += right;
    angles.elevation = std::clamp(angles.elevation + up, -kSteepest, kSteepest);
    return directionOf(angles);
}

} // namespace

OrbitCamera::OrbitCamera(const scene::Camera& camera, float distance) : camera_(camera) {
    target_ = position() + ahead() * std::max(distance, kNearest);
}

void OrbitCamera::place(const glm::vec3& position, const glm::vec3& target) {
    camera_.viewToWorld = scene::lookAt(position, target);
    target_ = target;
    moved_ = true;
}

void OrbitCamera::orbit(float right, float up) {
    const float far = distance();
    place(target_ - turned(ahead(), right, up) * far, target_);
}

void OrbitCamera::look(float right, float up) {
    place(position(), position() + turned(ahead(), right, up) * distance());
}

void OrbitCamera::pan(float right, float up) {
    const float height = camera_.orthographic ? camera_.orthoHeight : 2 * distance() * std::tan(camera_.fovY / 2);
    const glm::vec3 step =
        (glm::vec3(camera_.viewToWorld[0]) * right + glm::vec3(camera_.viewToWorld[1]) * up) * height;
    place(position() + step, target_ + step);
}

void OrbitCamera::dolly(float factor) {
    const float far = std::max(distance() * factor, kNearest);
    camera_.orthoHeight = std::clamp(camera_.orthoHeight * factor, 1e-6f, 1e6f);
    place(target_ - ahead() * far, target_);
}

void OrbitCamera::fly(const glm::vec3& rightUpAhead) {
    const glm::vec3 step = glm::mat3(camera_.viewToWorld) * glm::vec3(rightUpAhead.x, rightUpAhead.y, -rightUpAhead.z);
    place(position() + step, target_ + step);
}

void OrbitCamera::focus(const glm::vec3& pointWS) {
    if (glm::distance(pointWS, position()) < kNearest)
        return;
    const float far = std::clamp(distance(), kNearest, glm::distance(pointWS, position()));
    place(pointWS - glm::normalize(pointWS - position()) * far, pointWS);
}

void OrbitCamera::follow(const scene::Camera& camera) {
    if (moved_)
        return;
    const float far = distance();
    camera_ = camera;
    target_ = position() + ahead() * far;
}

void OrbitCamera::settle(const scene::Camera& camera) {
    const float far = distance();
    camera_ = camera;
    target_ = position() + ahead() * far;
    moved_ = true;
}

std::string OrbitCamera::json(uint32_t width, uint32_t height) const {
    const auto vector = [](const glm::vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); };
    const std::string lens = camera_.orthographic ? fmt::format("\"orthoHeight\": {}", camera_.orthoHeight)
                                                  : fmt::format("\"fovY\": {}", glm::degrees(camera_.fovY));
    const std::string far = std::isfinite(camera_.far) ? fmt::format(", \"far\": {}", camera_.far) : std::string();
    return fmt::format(
        "{{\n  \"position\": {},\n  \"target\": {},\n  {}, \"near\": {}{},\n  \"width\": {}, \"height\": "
        "{}\n}}\n",
        vector(position()), vector(target_), lens, camera_.near, far, width, height);
}

bool sameCamera(const scene::Camera& a, const scene::Camera& b) {
    return a.viewToWorld == b.viewToWorld && a.orthographic == b.orthographic && a.fovY == b.fovY &&
           a.orthoHeight == b.orthoHeight && a.near == b.near && a.far == b.far;
}

} // namespace glint::view
