// The geometry of a planar mirror; include/glint/planar.hpp documents the functions.
#pragma once

#include "glint/planar.hpp"
#include "reflect/host_numbers.hpp"

#include <algorithm>

namespace glint::reflect {

/// Returns the distance from the plane, in metres, within which surfaces belong to the mirror.
inline float toleranceOf(const PlanarMirror& mirror) {
    return mirror.tolerance > 0 ? mirror.tolerance : 2e-4f * std::max(mirror.halfExtents[0], mirror.halfExtents[1]);
}

} // namespace glint::reflect
