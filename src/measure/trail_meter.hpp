// How much of each earlier frame still shows: ghosting as an impulse response.
#pragma once

#include "measure/motion_frame.hpp"

#include <deque>

namespace glint::measure {

constexpr size_t kTrailFrames = 16;

/// `[k - 1]`: share of what the reference showed k frames ago that the tested frame still shows, 1: all of it, 0: none.
/// NaN if the reference does not change. Shares of different k overlap, as earlier frames resemble each other.
using TrailFigures = std::array<double, kTrailFrames>;

class TrailMeter {
public:
    /// Requires a reference. `counts`: false for frames before the end of the warm-up.
    void add(const MotionFrame& frame, bool counts);
    TrailFigures figures(size_t band) const;

private:
    std::deque<std::array<Radiance, 2>> references_; ///< of the last frames, the latest first
    std::array<BandSums<3>, kTrailFrames> sums_;
};

/// Sums for the share `beta` of a wrong radiance in the tested one, `test - now = beta (wrong - now)`, by least squares
/// over values where the wrong radiance differs. Both radiances have two estimates with independent noise: one selects
/// the values and weighs them, the other one is measured, so that noise neither selects itself nor dilutes the share
/// (an instrumental variable: Wright 1928, "The Tariff on Animal and Vegetable Oils", appendix B).
struct ShareTerms {
    double product = 0;    ///< of the tested difference and the weighing one
    double square = 0;     ///< of the two estimates of the wrong difference
    double difference = 0; ///< of the weighing estimate alone: shows if the difference is more than noise
};
ShareTerms shareTerms(double test, const std::array<double, 2>& now, const std::array<double, 2>& wrong);
/// Returns beta; NaN if the two estimates do not agree that there is a difference.
double shareOf(const ShareTerms& sums);

} // namespace glint::measure
