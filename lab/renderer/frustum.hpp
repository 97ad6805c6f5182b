// Which items a view may show: the others are not drawn.
#pragma once

#include "lab/scene/pose.hpp"

#include <glm/glm.hpp>

#include <array>

namespace glint::render {

class Frustum {
public:
    /// `worldToClip`: reversed depth, 1 at the near plane (docs/conventions.md).
    explicit Frustum(const glm::mat4& worldToClip);

    /// Returns false only for boxes outside the view. The view is taken 1 % wider than it is, because lines and points
    /// are wider than their vertices. Some boxes beyond a corner of the view pass, and so do boxes with a NaN.
    bool mayShow(const scene::Bounds& boundsWS) const;

private:
    std::array<glm::vec4, 5> planes_ = {}; ///< left, right, bottom, top, near: inside is where dot(plane, (p, 1)) >= 0
};

} // namespace glint::render
