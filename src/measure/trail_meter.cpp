#include "measure/trail_meter.hpp"

#include <cmath>
#include <limits>

namespace glint::measure {

ShareTerms shareTerms(double test, const std::array<double, 2>& now, const std::array<double, 2>& wrong) {
    constexpr double kRelative = 0.1, kAbsolute = 0.01; // radiance
    ShareTerms terms;
    for (size_t weigh = 0; weigh < 2; ++weigh) {
        const size_t measure = 1 - weigh;
        const double difference = wrong[weigh] - now[weigh];
        if (!(std::abs(difference) > kRelative * now[weigh] + kAbsolute))
            continue;
        terms.product += (test - now[measure]) * difference;
        terms.square += (wrong[measure] - now[measure]) * difference;
        terms.difference += difference * difference;
    }
    return terms;
}

double shareOf(const ShareTerms& sums) {
    constexpr double kAgreement = 0.1; // of pure noise, the mean is 0
    return sums.difference > 0 && sums.square > kAgreement * sums.difference ? sums.product / sums.square
                                                                             : std::numeric_limits<double>::quiet_NaN();
}

void TrailMeter::add(const MotionFrame& frame, bool counts) {
    for (size_t k = 0; counts && k < references_.size(); ++k) {
        const std::array<Radiance, 2>& before = references_[k];
        for (size_t p = 0; p < frame.pixels(); ++p) {
            const uint8_t band = (*frame.bands)[p];
            if (band == kNoBand)
                continue;
            for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
                const ShareTerms terms =
                    shareTerms(frame.testMean(i), {(*frame.reference[0])[i], (*frame.reference[1])[i]},
                               {(*before[0])[i], (*before[1])[i]});
                std::array<double, 3>& to = sums_[k][band];
                to[0] += terms.product;
                to[1] += terms.square;
                to[2] += terms.difference;
            }
        }
    }
    references_.push_front(frame.reference);
    if (references_.size() > kTrailFrames)
        references_.pop_back();
}

TrailFigures TrailMeter::figures(size_t band) const {
    TrailFigures figures;
    for (size_t k = 0; k < kTrailFrames; ++k) {
        const std::array<double, 3> sums = sums_[k].of(band);
        figures[k] = shareOf({sums[0], sums[1], sums[2]});
    }
    return figures;
}

} // namespace glint::measure
