#include "frame_pace.hpp"

namespace glint::view {

void FramePace::rendered(uint32_t divisor, double milliseconds) {
    const double whole = milliseconds * divisor * divisor;
    if (divisor == 1) // the truth; what coarse frames tell of it is a guess, for they cost more a pixel
        wholeMs_ = whole;
    else if (wholeMs_ == 0)
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
