// What disoccluded surfaces show: how much of what hid them, and how long until they are as good as others.
#pragma once

#include "lab/measure/motion/motion_frame.hpp"
#include "lab/measure/motion/surface_motion.hpp"
#include "lab/measure/truth/radiance_share.hpp"

namespace glint::measure {

constexpr size_t kGhostAges = 32;           ///< frames after which a disoccluded surface counts as any other
constexpr uint64_t kFewestGhostPixels = 64; ///< fewer pixels of an age say nothing

struct GhostFigures {
    /// By the frames since the disocclusion: share of the radiance that the earlier frame had in the surface's place.
    /// NaN for too few pixels, or if that radiance was the same.
    std::array<Share, kGhostAges> ghost = {};
    /// Likewise: relative mean squared error, divided by that of surfaces that were not disoccluded.
    std::array<double, kGhostAges> error = {};
    double heal = 0;          ///< the first age whose `error` is at most 2; NaN: none
    uint64_t disoccluded = 0; ///< pixels, all frames together
};

class GhostMeter {
public:
    /// Requires a reference. `motion` since the frame added last. `counts`: false for frames before the end of the
    /// warm-up, whose old surfaces are no measure.
    void add(const MotionFrame& frame, const SurfaceMotion& motion, bool counts);
    GhostFigures figures(size_t band) const;

private:
    static constexpr uint8_t kOld = kGhostAges;
    struct Pixel {
        uint8_t age = kOld;                             ///< frames since the disocclusion; kOld: long ago or never
        bool knowsGhost = false;                        ///< `ghost` is set
        std::array<std::array<float, 3>, 2> ghost = {}; ///< of the two references, before the disocclusion
    };
    void moveAges(const MotionFrame& frame, const SurfaceMotion& motion);

    std::vector<Pixel> pixels_;
    std::array<Radiance, 2> prevReference_;
    std::array<BandSums<2>, kGhostAges + 1> errors_; ///< by age, the last: kOld. Sum, number of pixels
    std::array<ByBand<ShareSeries>, kGhostAges> shares_;
};

} // namespace glint::measure
