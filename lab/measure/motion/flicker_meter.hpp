// Figures of the change from frame to frame: noise that moves, and errors that move.
#pragma once

#include "lab/measure/motion/frame_series.hpp"
#include "lab/measure/motion/motion_frame.hpp"

namespace glint::measure {

struct FlickerFigures {
    SeriesFigure flicker; ///< noise of the change, relative to the mean radiance; needs no reference
    SeriesFigure swim;    ///< systematic error of the change, likewise; NaN without reference
    double tPsnr = 0;     ///< dB: peak 1 over the mean squared error of the change; infinite if there is none
};

class FlickerMeter {
public:
    /// Compares with the frame that was added last. `counts`: false for frames before the end of the warm-up.
    void add(const MotionFrame& frame, bool counts);
    FlickerFigures figures(size_t band) const;

private:
    struct Series {
        FrameSeries flicker, swim, change;
    };
    ByBand<Series> series_;
    MotionFrame prev_;
};

} // namespace glint::measure
