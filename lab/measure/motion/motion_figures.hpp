// The figures of a moving picture (docs/motion.md): how right, how still, how quick, how sharp.
#pragma once

#include "lab/measure/motion/flicker_meter.hpp"
#include "lab/measure/motion/frame_error_meter.hpp"
#include "lab/measure/motion/ghost_meter.hpp"
#include "lab/measure/motion/step_meter.hpp"
#include "lab/measure/motion/trail_meter.hpp"

namespace glint::measure {

/// Without reference only `flicker.flicker` is known; the rest is NaN or empty.
struct MotionBandFigures {
    FrameErrorFigures error;
    FlickerFigures flicker;
    TrailFigures trail = {};
    TrailFigures lead = {};
    GhostFigures ghost;
    std::vector<StepResponse> steps;
};

/// By RoughnessBand; the last: all reflective pixels.
using MotionFigures = ByBand<MotionBandFigures>;

class MotionMeter {
public:
    /// `warmUp`  frames that count for no mean
    /// `steps`   first frames that show a sudden change of light, in order
    MotionMeter(uint32_t warmUp, std::vector<uint32_t> steps) : warmUp_(warmUp), steps_(std::move(steps)) {}

    /// Adds the next frame. `motion` since the one before.
    void add(const MotionFrame& frame, const SurfaceMotion& motion);
    MotionFigures figures() const;

private:
    uint32_t warmUp_;
    uint32_t next_ = 0;
    FrameErrorMeter error_;
    FlickerMeter flicker_;
    TrailMeter trail_;
    GhostMeter ghost_;
    StepMeter steps_;
};

/// The figures of frames that were given as both seeds: those that need two are NaN. The relative error keeps its
/// meaning, since its noise then is part of the first product.
MotionFigures ofOneSeed(MotionFigures figures);

} // namespace glint::measure
