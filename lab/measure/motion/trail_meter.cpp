#include "lab/measure/motion/trail_meter.hpp"

namespace glint::measure {
namespace {

void addShares(const MotionFrame& tested, const std::array<Radiance, 2>& other, ByBand<ShareSeries>& shares) {
    BandSums<3> sums;
    for (size_t p = 0; p < tested.pixels(); ++p) {
        const uint8_t band = (*tested.bands)[p];
        if (band == kNoBand)
            continue;
        for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
            const ShareTerms terms =
                shareTerms(tested.testMean(i), {(*tested.reference[0])[i], (*tested.reference[1])[i]},
                           {(*other[0])[i], (*other[1])[i]});
            sums[band][0] += terms.product;
            sums[band][1] += terms.square;
            sums[band][2] += terms.difference;
        }
    }
    for (size_t band = 0; band <= kBands; ++band)
        shares[band].add({sums.of(band)[0], sums.of(band)[1], sums.of(band)[2]});
}

TrailFigures sharesOf(const std::array<ByBand<ShareSeries>, kTrailFrames>& shares, size_t band) {
    TrailFigures figures;
    for (size_t k = 0; k < kTrailFrames; ++k)
        figures[k] = shares[k][band].share();
    return figures;
}

} // namespace

void TrailMeter::add(const MotionFrame& frame, bool counts) {
    for (size_t k = 0; k < before_.size(); ++k) {
        if (counts)
            addShares(frame, before_[k].frame.reference, trails_[k]);
        if (before_[k].counts)
            addShares(before_[k].frame, frame.reference, leads_[k]);
    }
    before_.push_front({frame, counts});
    if (before_.size() > kTrailFrames)
        before_.pop_back();
}

TrailFigures TrailMeter::trail(size_t band) const {
    return sharesOf(trails_, band);
}

TrailFigures TrailMeter::lead(size_t band) const {
    return sharesOf(leads_, band);
}

} // namespace glint::measure
