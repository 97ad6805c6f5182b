// How finely a moving picture is rendered, so that the window answers in time on a slow device too.
#pragma once

#include <cstdint>

namespace glint::view {

/// While something moves, the picture has 1/2, 1/4 or 1/8 of the window's pixels a side if whole frames take longer
/// than kLongestFrame; when it has stood still for kStillSeconds, all of them.
class FramePace {
public:
    static constexpr double kLongestFrame = 100; ///< milliseconds
    static constexpr double kStillSeconds = 0.2; ///< long enough to move the hand on
    static constexpr uint32_t kCoarsest = 8;

    /// A frame of width/divisor x height/divisor pixels took so long.
    void rendered(uint32_t divisor, double milliseconds);
    void moved(double now) { lastMove_ = now; }
    bool moving(double now) const { return now - lastMove_ < kStillSeconds; }
    /// What the next frame's size is divided by: 1, 2, 4 or 8.
    uint32_t divisor(double now) const;

private:
    double wholeMs_ = 0; ///< of a frame with all pixels, as far as is known
    double lastMove_ = -1e9;
};

} // namespace glint::view
