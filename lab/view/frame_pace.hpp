// Reduces the resolution of a moving picture, so that the window stays responsive on a slow device.
#pragma once

#include <cstdint>

namespace glint::view {

/// While something moves, and if full frames take longer than kLongestFrame, the picture has 1/2, 1/4 or 1/8 of the
/// window's pixels per side. After kStillSeconds without movement it has all of them.
class FramePace {
public:
    static constexpr double kLongestFrame = 100; ///< milliseconds
    static constexpr double kStillSeconds = 0.2; ///< seconds: long enough for short pauses of the user's hand
    static constexpr uint32_t kCoarsest = 8;

    /// Reports the time of a frame of width/divisor x height/divisor pixels.
    void rendered(uint32_t divisor, double milliseconds);
    void moved(double now) { lastMove_ = now; }
    bool moving(double now) const { return now - lastMove_ < kStillSeconds; }
    /// Returns the divisor of the next frame's size: 1, 2, 4 or 8.
    uint32_t divisor(double now) const;

private:
    double wholeMs_ = 0; ///< estimated time of a frame with all pixels
    double lastMove_ = -1e9;
};

} // namespace glint::view
