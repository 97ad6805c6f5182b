// Where paths of rays end (shaders/rays/path_end.glsl).
#pragma once

#include "glint/settings.hpp"

namespace glint::reflect {

/// True if what the last surface of a path reflects may be taken from the previous frame's picture. Not for a mean over
/// frames: that is the truth, and depends on no picture.
inline bool endsInPrevious(const Settings& settings) {
    return settings.rays.enabled && settings.rays.environmentOcclusion && !settings.rays.accumulate;
}

} // namespace glint::reflect
