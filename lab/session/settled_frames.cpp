#include "lab/session/settled_frames.hpp"

#include <algorithm>
#include <cmath>

namespace glint::render {

namespace {

/// Frames after which what paths' ends take from the previous picture no longer changes much: each adds a path's
/// bounces.
constexpr uint32_t kFramesOfEnds = 8;

bool accumulates(const Settings& settings) {
    return settings.rays.enabled && settings.rays.accumulate;
}

} // namespace

uint32_t settledFrames(const Settings& settings) {
    uint32_t frames = 1;
    const bool traces = settings.screen.enabled || settings.rays.enabled;
    if (settings.denoise.enabled && traces && !accumulates(settings))
        frames = static_cast<uint32_t>(std::ceil(settings.denoise.historySeconds * kFramesPerSecond));
    // The first frame has no previous one.
    uint32_t least = settings.screen.enabled && settings.screen.colorSource == ColorSource::Previous ? 2 : 1;
    if (settings.rays.enabled && settings.rays.environmentOcclusion && !accumulates(settings))
        least = kFramesOfEnds;
    return std::max(frames, least);
}

uint32_t mostSettlingFrames(const Settings& settings) {
    return accumulates(settings) ? 1024 : settledFrames(settings);
}

} // namespace glint::render
