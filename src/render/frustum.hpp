// What a view cannot show: items outside of it are not drawn.
#pragma once

#include "scene/pose.hpp"

#include <glm/glm.hpp>

#include <array>

namespace glint::render {

class Frustum {
public:
    /// `worldToClip`: reversed depth, 1 at the near plane (docs/conventions.md).
    explicit Frustum(const glm::mat4& worldToClip);

    /// False if a box, and whatever lies within a hundredth of the image's half width around it, is outside: also lines
    /// and points are wider than their vertices. Boxes that are not numbers are inside. Where a box is beyond a corner
    /// of the view the answer may be true.
    bool mayShow(const scene::Bounds& boundsWS) const;

private:
    std::array<glm::vec4, 5> planes_ = {}; ///< left, right, bottom, top, near: inside is where dot(plane, (p, 1)) >= 0
};

/// The smallest box in world space around a transformed box; empty for an empty one.
scene::Bounds transformedBounds(const scene::Bounds& local, const glm::mat4& localToWorld);

} // namespace glint::render
