#include "lab/view/frame_pace.hpp"

namespace glint::view {

void FramePace::rendered(uint32_t divisor, double milliseconds) {
    const double whole = milliseconds * divisor * divisor;
    // Coarse frames cost more per pixel: they give only the first estimate of a full frame.
    if (divisor == 1 || wholeMs_ == 0)
        wholeMs_ = whole;
}

uint32_t FramePace::divisor(double now) const {
    uint32_t divisor = 1;
    if (moving(now))
        while (divisor < kCoarsest && wholeMs_ / (divisor * divisor) > kLongestFrame)
            divisor *= 2;
    return divisor;
}

} // namespace glint::view
