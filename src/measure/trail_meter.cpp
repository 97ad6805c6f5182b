#include "measure/trail_meter.hpp"

namespace glint::measure {

void TrailMeter::add(const MotionFrame& frame, bool counts) {
    for (size_t k = 0; counts && k < references_.size(); ++k) {
        const std::array<Radiance, 2>& before = references_[k];
        BandSums<3> sums;
        for (size_t p = 0; p < frame.pixels(); ++p) {
            const uint8_t band = (*frame.bands)[p];
            if (band == kNoBand)
                continue;
            for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
                const ShareTerms terms =
                    shareTerms(frame.testMean(i), {(*frame.reference[0])[i], (*frame.reference[1])[i]},
                               {(*before[0])[i], (*before[1])[i]});
                sums[band][0] += terms.product;
                sums[band][1] += terms.square;
                sums[band][2] += terms.difference;
            }
        }
        for (size_t band = 0; band <= kBands; ++band)
            shares_[k][band].add({sums.of(band)[0], sums.of(band)[1], sums.of(band)[2]});
    }
    references_.push_front(frame.reference);
    if (references_.size() > kTrailFrames)
        references_.pop_back();
}

TrailFigures TrailMeter::figures(size_t band) const {
    TrailFigures figures;
    for (size_t k = 0; k < kTrailFrames; ++k)
        figures[k] = shares_[k][band].share();
    return figures;
}

} // namespace glint::measure
