#include "lab/measure/motion/ghost_meter.hpp"

#include "lab/measure/motion/frame_error_meter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::measure {

void GhostMeter::moveAges(const MotionFrame& frame, const SurfaceMotion& motion) {
    const auto grow = [](Pixel& pixel) {
        if (pixel.age < kOld)
            ++pixel.age;
    };
    if (pixels_.empty())
        pixels_.resize(frame.pixels());
    if (motion.empty()) {
        std::ranges::for_each(pixels_, grow);
        return;
    }
    std::vector<Pixel> moved(frame.pixels());
    for (size_t p = 0; p < moved.size(); ++p) {
        Pixel& pixel = moved[p];
        switch (motion[p].origin) {
        case SurfaceOrigin::Seen:
            pixel = pixels_[motion[p].pixel];
            grow(pixel);
            break;
        case SurfaceOrigin::Hidden:
            pixel.age = 0;
            pixel.knowsGhost = true;
            for (size_t k = 0; k < 2; ++k)
                std::copy_n(prevReference_[k]->data() + size_t{3} * motion[p].pixel, 3, pixel.ghost[k].data());
            break;
        case SurfaceOrigin::Outside: pixel.age = 0; break;
        case SurfaceOrigin::None: break;
        }
    }
    pixels_ = std::move(moved);
}

void GhostMeter::add(const MotionFrame& frame, const SurfaceMotion& motion, bool counts) {
    moveAges(frame, prevReference_[0] ? motion : SurfaceMotion());
    prevReference_ = frame.reference;
    std::array<BandSums<3>, kGhostAges> shares;
    for (size_t p = 0; p < frame.pixels(); ++p) {
        const uint8_t band = (*frame.bands)[p];
        const Pixel& pixel = pixels_[p];
        if (band == kNoBand || (pixel.age == kOld && !counts))
            continue;
        std::array<double, 2>& errors = errors_[pixel.age][band];
        errors[1] += 1;
        for (size_t c = 0; c < 3; ++c) {
            const size_t i = 3 * p + c;
            const RelativeError error = relativeError(frame, i);
            errors[0] += (error.bias + error.noise) / 3;
            if (pixel.age == kOld || !pixel.knowsGhost)
                continue;
            const ShareTerms terms = shareTerms(frame.testMean(i), {(*frame.reference[0])[i], (*frame.reference[1])[i]},
                                                {pixel.ghost[0][c], pixel.ghost[1][c]});
            std::array<double, 3>& sums = shares[pixel.age][band];
            sums[0] += terms.product;
            sums[1] += terms.square;
            sums[2] += terms.difference;
        }
    }
    for (size_t age = 0; age < kGhostAges; ++age)
        for (size_t band = 0; band <= kBands; ++band)
            shares_[age][band].add({shares[age].of(band)[0], shares[age].of(band)[1], shares[age].of(band)[2]});
}

GhostFigures GhostMeter::figures(size_t band) const {
    constexpr double kHealed = 2, kNone = std::numeric_limits<double>::quiet_NaN();
    GhostFigures figures;
    figures.heal = kNone;
    const std::array<double, 2> old = errors_[kOld].of(band);
    figures.disoccluded = static_cast<uint64_t>(errors_[0].of(band)[1]);
    for (size_t age = 0; age < kGhostAges; ++age) {
        const std::array<double, 2> error = errors_[age].of(band);
        const bool enough = error[1] >= double(kFewestGhostPixels);
        figures.ghost[age] = enough ? shares_[age][band].share() : Share{kNone, kNone};
        figures.error[age] = enough && old[0] > 0 ? error[0] / error[1] / (old[0] / old[1]) : kNone;
        if (std::isnan(figures.heal) && figures.error[age] <= kHealed)
            figures.heal = static_cast<double>(age);
    }
    return figures;
}

} // namespace glint::measure
