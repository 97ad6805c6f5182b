// Says when the mean over a still view's frames has stopped moving, so that no more frames are rendered than it needs.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace glint::render {

/// Compares the displayed picture of n frames with that of half as many. If the picture is a mean of n frames, the
/// difference has the standard deviation of that mean: mean(n) - mean(n/2) = (mean of the second half - mean of the
/// first) / 2, whose variance is that of a frame, divided by n. A picture without noise settles in two frames.
class Settling {
public:
    /// `error`  > 0, of 255 levels: the root mean square of the difference, over all pixels and channels, at which the
    ///          picture has settled
    explicit Settling(double error) : most_(error) {}

    /// True if the picture is looked at after so many frames: after 1, 2, 3, 4, 6, 8, 12, 16, 24, ...
    static bool looksAfter(uint32_t frames);
    /// True if the picture has settled. `frames` must be the next number of looksAfter; `rgb8` has always one size.
    bool settled(uint32_t frames, std::vector<uint8_t> rgb8);
    /// The last difference; infinite before there was one.
    double error() const { return error_; }

private:
    double most_;
    double error_ = std::numeric_limits<double>::infinity();
    std::map<uint32_t, std::vector<uint8_t>> pictures_; ///< by their frames, as far as they are still needed
};

} // namespace glint::render
