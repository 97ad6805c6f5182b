#include "lab/measure/motion/motion_figures.hpp"

#include <limits>

namespace glint::measure {

void MotionMeter::add(const MotionFrame& frame, const SurfaceMotion& motion) {
    const uint32_t index = next_++;
    const bool counts = index >= warmUp_;
    flicker_.add(frame, counts);
    if (!frame.hasReference())
        return;
    if (counts)
        error_.add(frame);
    trail_.add(frame, counts);
    ghost_.add(frame, motion, counts);
    steps_.add(frame, index);
}

MotionFigures MotionMeter::figures() const {
    MotionFigures figures;
    for (size_t band = 0; band <= kBands; ++band)
        figures[band] = {error_.figures(band), flicker_.figures(band), trail_.trail(band),
                         trail_.lead(band),    ghost_.figures(band),   steps_.figures(band)};
    return figures;
}

MotionFigures ofOneSeed(MotionFigures figures) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    constexpr SeriesFigure kUnknownSeries = {kUnknown, kUnknown, kUnknown};
    for (MotionBandFigures& band : figures) {
        band.error.bias = band.error.noise = band.error.sharp = kUnknownSeries;
        band.flicker.flicker = band.flicker.swim = kUnknownSeries;
    }
    return figures;
}

} // namespace glint::measure
