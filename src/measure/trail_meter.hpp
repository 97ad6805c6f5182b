// How much of each earlier frame still shows: ghosting as an impulse response.
#pragma once

#include "measure/motion_frame.hpp"
#include "measure/radiance_share.hpp"

#include <deque>

namespace glint::measure {

constexpr size_t kTrailFrames = 16;

/// `[k - 1]`: share of what the reference showed k frames ago that the tested frame still shows, 1: all of it, 0: none.
/// NaN if the reference does not change. Shares of different k overlap, as earlier frames resemble each other.
using TrailFigures = std::array<Share, kTrailFrames>;

class TrailMeter {
public:
    /// Requires a reference. `counts`: false for frames before the end of the warm-up.
    void add(const MotionFrame& frame, bool counts);
    TrailFigures figures(size_t band) const;

private:
    std::deque<std::array<Radiance, 2>> references_;       ///< of the last frames, the latest first
    std::array<ByBand<ShareSeries>, kTrailFrames> shares_; ///< by age
};

} // namespace glint::measure
