// A camera in the world: position, direction and lens. Conventions: docs/conventions.md.
#pragma once

#include "base/result.hpp"

#include <glm/glm.hpp>

#include <limits>
#include <string>

namespace glint::scene {

struct Bounds;

struct Camera {
    std::string name;
    glm::mat4 viewToWorld = glm::mat4(1); ///< rigid; looks down -Z, +Y up
    bool orthographic = false;
    float fovY = 0.7f;     ///< radians, (0, pi)
    float orthoHeight = 2; ///< metres, whole height
    float aspectRatio = 0; ///< width / height that the camera was made for; 0: any
    float near = 0.05f;    ///< metres, > 0
    /// Metres; must be finite for orthographic cameras, which use it.
    float far = std::numeric_limits<float>::infinity();
    int width = 0; ///< suggested image size in pixels; 0: none
    int height = 0;
};

/// Reads {"position","target","fovY"|"orthoHeight","width","height","near","far"}. Errors name the file and the key.
Result<Camera> readCameraFile(const std::string& path);

/// Returns the transform of a camera at `position` that looks at `target`, +Y up (or -Z up when looking straight up or
/// down).
glm::mat4 lookAt(const glm::vec3& position, const glm::vec3& target);

/// Returns a three-quarter view in which the whole box fits for this aspect ratio. An empty `bounds` is replaced by a
/// unit box.
Camera frameBounds(const Bounds& bounds, float aspectRatio);

} // namespace glint::scene
