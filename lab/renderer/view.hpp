// A camera and an image size, as matrices. Conventions: docs/conventions.md.
#pragma once

#include "lab/scene/camera.hpp"

#include <glm/glm.hpp>

#include <cstdint>

namespace glint::render {

struct View {
    uint32_t width = 1;  ///< pixels
    uint32_t height = 1; ///< pixels
    bool orthographic = false;
    glm::mat4 worldToView = glm::mat4(1);
    glm::mat4 viewToWorld = glm::mat4(1);
    glm::mat4 viewToClip = glm::mat4(1); ///< +Y up, reversed depth, jitter included
    glm::mat4 worldToClip = glm::mat4(1);
    glm::mat4 clipToWorld = glm::mat4(1);
    glm::vec2 jitterUV = glm::vec2(0); ///< UV offset that the jitter adds to a point

    glm::vec3 positionWS() const { return glm::vec3(viewToWorld[3]); }
    glm::vec3 forwardWS() const { return -glm::vec3(viewToWorld[2]); }
};

/// `jitterPX`  pixels, [-0.5, 0.5]: shifts the image to the right and down, for temporal antialiasing
View makeView(const scene::Camera& camera, uint32_t width, uint32_t height, glm::vec2 jitterPX = glm::vec2(0));

/// Perspective: reversed and infinite, depth = near / viewZ. Orthographic: reversed and linear, from 1 at `near` to 0
/// at `far`; an infinite `far` becomes near + 1 km.
glm::mat4 projection(const scene::Camera& camera, float aspectRatio);

} // namespace glint::render
