#include "lab/measure/motion/flicker_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glint::measure {
namespace {

enum FlickerTerm : size_t { FlickerValues, FlickerNoise, FlickerError, FlickerDisplay, FlickerMean, FlickerTerms };

double onDisplay(float radiance) {
    return std::clamp(double(radiance), 0.0, 1.0);
}

} // namespace

void FlickerMeter::add(const MotionFrame& frame, bool counts) {
    const MotionFrame prev = std::exchange(prev_, frame);
    if (!counts || !prev.bands)
        return;
    BandSums<FlickerTerms> sums;
    for (size_t p = 0; p < frame.pixels(); ++p) {
        const uint8_t band = (*frame.bands)[p];
        if (band == kNoBand || (*prev.bands)[p] != band)
            continue;
        std::array<double, FlickerTerms>& to = sums[band];
        for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
            const auto change = [&](const Radiance& now, const Radiance& before) {
                return double((*now)[i]) - double((*before)[i]);
            };
            const double d1 = change(frame.test[0], prev.test[0]), d2 = change(frame.test[1], prev.test[1]);
            to[FlickerNoise] += (d1 - d2) * (d1 - d2) / 2;
            to[FlickerMean] += frame.hasReference() ? frame.referenceMean(i) : frame.testMean(i);
            to[FlickerValues] += 1;
            if (!frame.hasReference())
                continue;
            const double da = change(frame.reference[0], prev.reference[0]);
            const double db = change(frame.reference[1], prev.reference[1]);
            to[FlickerError] += (d1 - da) * (d2 - db);
            // The reference's noise cancels in the product, the tested noise stays: it is part of this figure.
            const auto shown = [&](const Radiance& now, const Radiance& before) {
                return onDisplay((*now)[i]) - onDisplay((*before)[i]);
            };
            const double ra = shown(frame.reference[0], prev.reference[0]);
            const double rb = shown(frame.reference[1], prev.reference[1]);
            for (size_t seed = 0; seed < 2; ++seed) {
                const double x = shown(frame.test[seed], prev.test[seed]);
                to[FlickerDisplay] += (x - ra) * (x - rb) / 2;
            }
        }
    }
    for (size_t band = 0; band <= kBands; ++band) {
        const std::array<double, FlickerTerms> all = sums.of(band);
        const double mean = all[FlickerMean] / all[FlickerValues];
        if (!(mean > 0)) // no pixels, or a black reference, or NaN
            continue;
        Series& series = series_[band];
        series.flicker.add(all[FlickerNoise] / all[FlickerValues] / (mean * mean));
        if (!frame.hasReference())
            continue;
        series.swim.add(all[FlickerError] / all[FlickerValues] / (mean * mean));
        series.change.add(all[FlickerDisplay] / all[FlickerValues]);
    }
}

FlickerFigures FlickerMeter::figures(size_t band) const {
    const Series& series = series_[band];
    const double change = series.change.figure().mean;
    const double tPsnr = std::isnan(change) ? change
                         : change > 0       ? -10 * std::log10(change)
                                            : std::numeric_limits<double>::infinity();
    return {series.flicker.root(), series.swim.root(), tPsnr};
}

} // namespace glint::measure
