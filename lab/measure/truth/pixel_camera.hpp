// Converts between pixels and world space in double precision, for figures that must not depend on rounding.
#pragma once

#include "lab/renderer/view.hpp"

namespace glint::measure {

/// A ray from the eye (or, orthographic, from the near plane) through a point of the image.
struct PixelRay {
    glm::dvec3 originWS = glm::dvec3(0);           ///< on the near plane
    glm::dvec3 directionWS = glm::dvec3(0, 0, -1); ///< unit
};

class PixelCamera {
public:
    explicit PixelCamera(const render::View& view)
        : width_(view.width), height_(view.height), eyeWS_(view.positionWS()),
          forwardWS_(glm::normalize(glm::dvec3(view.forwardWS()))),
          worldToClip_(glm::dmat4(view.viewToClip) * glm::dmat4(view.worldToView)),
          clipToWorld_(glm::inverse(worldToClip_)) {
        nearZ_ = viewZ(ray(glm::dvec2(width_, height_) * 0.5).originWS);
    }

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    double nearZ() const { return nearZ_; } ///< metres along the view axis

    /// `px`  pixels from the top left, centres at .5
    PixelRay ray(const glm::dvec2& px) const {
        const glm::dvec3 origin = unproject(px, 1); // reversed depth: on the near plane
        return {origin, glm::normalize(unproject(px, 0.5) - origin)};
    }
    double viewZ(const glm::dvec3& positionWS) const { return glm::dot(positionWS - eyeWS_, forwardWS_); }
    /// Returns the point of a ray at distance `viewZ`, in metres along the view axis.
    glm::dvec3 position(const PixelRay& ray, double viewZ) const {
        return ray.originWS + ray.directionWS * ((viewZ - nearZ_) / glm::dot(ray.directionWS, forwardWS_));
    }
    /// Returns the pixel coordinates of a point in front of the near plane.
    glm::dvec2 project(const glm::dvec3& positionWS) const {
        const glm::dvec4 clip = worldToClip_ * glm::dvec4(positionWS, 1);
        return glm::dvec2(clip.x / clip.w * 0.5 + 0.5, 0.5 - clip.y / clip.w * 0.5) * glm::dvec2(width_, height_);
    }

private:
    glm::dvec3 unproject(const glm::dvec2& px, double depth) const {
        const glm::dvec2 uv = px / glm::dvec2(width_, height_);
        const glm::dvec4 point = clipToWorld_ * glm::dvec4(uv.x * 2 - 1, 1 - uv.y * 2, depth, 1);
        return glm::dvec3(point) / point.w;
    }

    uint32_t width_;
    uint32_t height_;
    glm::dvec3 eyeWS_;
    glm::dvec3 forwardWS_;
    glm::dmat4 worldToClip_;
    glm::dmat4 clipToWorld_;
    double nearZ_ = 0;
};

} // namespace glint::measure
