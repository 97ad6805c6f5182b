// How many frames of a still view it takes until further ones no longer change the picture much, by the settings alone.
// settling.hpp looks at the picture instead.
#pragma once

#include "glint/settings.hpp"

#include <cstdint>

namespace glint::render {

/// Frames per second of our programs' clock (View::seconds).
constexpr double kFramesPerSecond = 60;

/// As many as the settings' history holds: denoise.historySeconds, or the previous frame's colours, for hits or for the
/// ends of paths. rays.accumulate has no end, and counts as one.
uint32_t settledFrames(const Settings& settings);

/// The most frames of a picture that is rendered until it has settled (RenderJob::settle): settledFrames, or 1024 with
/// rays.accumulate.
uint32_t mostSettlingFrames(const Settings& settings);

} // namespace glint::render
