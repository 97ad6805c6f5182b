// Whether the denoiser takes part.
#pragma once

#include "glint/settings.hpp"

namespace glint::reflect {

/// rays.accumulate averages all samples of a still view, which is the truth in the end: nothing is to be smoothed
/// there.
inline bool denoises(const Settings& settings) {
    return settings.denoise.enabled && !(settings.rays.enabled && settings.rays.accumulate);
}

} // namespace glint::reflect
