#include "frame_pace.hpp"

namespace glint::view {

void FramePace::rendered(uint32_t divisor, double milliseconds) {
    const double whole = milliseconds * divisor * divisor;
    // The cost of a full frame is only estimated from coarse frames, which cost more per pixel.
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
