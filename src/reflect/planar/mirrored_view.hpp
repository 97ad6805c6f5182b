// The geometry of a planar mirror: include/glint/planar.hpp says what each gives.
#pragma once

#include "glint/planar.hpp"

#include <glm/glm.hpp>

#include <algorithm>

namespace glint::reflect {

inline glm::vec3 toVec(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// Metres off the plane within which surfaces are the mirror's own.
inline float toleranceOf(const PlanarMirror& mirror) {
    return mirror.tolerance > 0 ? mirror.tolerance : 2e-4f * std::max(mirror.halfExtents[0], mirror.halfExtents[1]);
}

} // namespace glint::reflect
