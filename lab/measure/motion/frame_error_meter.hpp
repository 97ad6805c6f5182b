// Figures of single frames: error against the reference, sharpness, energy, fireflies.
#pragma once

#include "lab/measure/motion/frame_series.hpp"
#include "lab/measure/motion/motion_frame.hpp"

namespace glint::measure {

struct FrameErrorFigures {
    SeriesFigure relativeMse; ///< bias + noise
    SeriesFigure bias;        ///< systematic part: blur, lag, lost energy; may be negative by the noise of its estimate
    SeriesFigure noise;       ///< part that changes with the seed
    SeriesFigure sharp;       ///< gain of gradients: below 1 blurred, above 1 crunched; NaN if the reference is flat
    SeriesFigure energy;      ///< tested over reference radiance
    SeriesFigure fireflies;   ///< per million pixels: brighter than 8 times the reference around them
    double pixels = 0;        ///< per frame, mean
};

class FrameErrorMeter {
public:
    /// Frames without reflective pixels of a band do not count for that band. Requires a reference.
    void add(const MotionFrame& frame);
    FrameErrorFigures figures(size_t band) const;

private:
    struct Series {
        FrameSeries relativeMse, bias, noise, sharp, energy, fireflies, pixels;
    };
    ByBand<Series> series_;
};

/// The terms of MotionFrame's error at value `i`, relative to the reference: bias squared, and noise. Based on:
/// Rousselle et al. 2011, "Adaptive Sampling and Reconstruction using Greedy Error Minimization" (the divisor).
struct RelativeError {
    double bias = 0;
    double noise = 0;
};
inline RelativeError relativeError(const MotionFrame& frame, size_t i) {
    const double x1 = (*frame.test[0])[i], x2 = (*frame.test[1])[i];
    const double a = (*frame.reference[0])[i], b = (*frame.reference[1])[i];
    const double mean = (a + b) / 2, divisor = mean * mean + 0.01;
    return {(x1 - a) * (x2 - b) / divisor, (x1 - x2) * (x1 - x2) / 2 / divisor};
}

} // namespace glint::measure
