// How much of each earlier frame still shows, and how much of each later one already does: ghosting as an impulse
// response, and what of it is blur.
#pragma once

#include "lab/measure/motion/motion_frame.hpp"
#include "lab/measure/truth/radiance_share.hpp"

#include <deque>

namespace glint::measure {

constexpr size_t kTrailFrames = 16;

/// `[k - 1]`: share of what the reference shows k frames earlier or later that the tested frame shows, 1: all of it, 0:
/// none. NaN if the reference does not change. Shares of different k overlap, as neighbouring frames resemble each
/// other.
using TrailFigures = std::array<Share, kTrailFrames>;

class TrailMeter {
public:
    /// Requires a reference. `counts`: false for frames before the end of the warm-up.
    void add(const MotionFrame& frame, bool counts);
    /// Of the frames before.
    TrailFigures trail(size_t band) const;
    /// Of the frames after, which cannot show. Blur that is even in space resembles both alike, up to 0.5 where it
    /// leaves nothing of the image. Lag makes the trail larger than the lead.
    TrailFigures lead(size_t band) const;

private:
    struct Before {
        MotionFrame frame;
        bool counts;
    };
    std::deque<Before> before_;                            ///< the last frames, the latest first
    std::array<ByBand<ShareSeries>, kTrailFrames> trails_; ///< by age
    std::array<ByBand<ShareSeries>, kTrailFrames> leads_;
};

} // namespace glint::measure
