// How long a sudden change of light takes to show.
#pragma once

#include "lab/measure/motion/motion_frame.hpp"

namespace glint::measure {

/// The response to one change. NaN where it did not get so far before the next change.
struct StepResponse {
    uint32_t frame = 0;   ///< the first frame that shows the change
    double lag90 = 0;     ///< frames from there until 90 % of the change show; 0: at once
    double lag99 = 0;     ///< likewise 99 %
    double overshoot = 0; ///< largest part beyond 100 %
    uint64_t pixels = 0;  ///< that change
};

class StepMeter {
public:
    /// `steps`: the first frames that show a change, in order.
    explicit StepMeter(std::vector<uint32_t> steps) : steps_(std::move(steps)) {}

    /// Requires a reference. Frames count from 0.
    void add(const MotionFrame& frame, uint32_t index);
    /// Steps that change nothing in this band are left out.
    std::vector<StepResponse> figures(size_t band) const;

private:
    /// A pixel whose light one of the two references shows changing; the other one measures by how much.
    struct Changed {
        uint32_t pixel = 0;
        uint8_t band = 0;
        uint8_t measure = 0; ///< index of the reference that measures
        float sign = 0;      ///< of the change
        float before = 0;    ///< luminance of the measuring reference
    };
    struct Step {
        uint32_t frame = 0;
        std::vector<Changed> changed;
        ByBand<bool> counts = {};
        ByBand<uint64_t> pixels = {};
        ByBand<std::vector<double>> rest; ///< of each frame since: share of the change that does not show yet
    };

    void begin(const MotionFrame& frame, uint32_t index);
    void follow(const MotionFrame& frame);

    std::vector<uint32_t> steps_;
    std::vector<Step> found_;
    std::array<std::vector<float>, 2> prevLuminance_; ///< of the references
};

} // namespace glint::measure
