// The geometry of a planar mirror: include/glint/planar.hpp says what each gives.
#pragma once

#include "glint/planar.hpp"
#include "reflect/host_numbers.hpp"

#include <algorithm>

namespace glint::reflect {

/// Metres off the plane within which surfaces are the mirror's own.
inline float toleranceOf(const PlanarMirror& mirror) {
    return mirror.tolerance > 0 ? mirror.tolerance : 2e-4f * std::max(mirror.halfExtents[0], mirror.halfExtents[1]);
}

} // namespace glint::reflect
