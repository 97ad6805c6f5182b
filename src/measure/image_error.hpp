// Figures for how far a picture is from another one: on radiance, for errors of light; on bytes, for tests against a
// stored picture. flip.hpp is the one that knows what people see.
#pragma once

#include "measure/display_picture.hpp"

namespace glint::measure {

/// Mean over pixels and colours of (test - reference)^2 / (reference^2 + 0.01), each radiance clamped to [0, 16] first,
/// so that dark places count as much as bright ones and no single firefly decides.
///
/// `reference`, `test`  linear radiance, four floats a pixel, the fourth ignored; of equal, not zero size
/// `mask`               one byte a pixel, 0: left out; empty: all count
/// Returns 0 where the mask leaves nothing; NaN if a counted value is NaN.
/// Based on: Rousselle et al. 2011, "Adaptive Sampling and Reconstruction using Greedy Error Minimization".
double relativeMse(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask = {});

/// Peak signal to noise ratio in dB: 10 log10(1 / mean squared error) with linear radiance clamped to [0, 1], peak 1.
/// Arguments as above. Returns infinity for equal pictures, and where the mask leaves nothing; NaN as above.
double psnr(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask = {});

/// Byte by byte.
struct DisplayDifference {
    double maxAbsDiff = 0;      ///< largest difference of a channel, [0, 1] (bytes / 255)
    uint64_t failingPixels = 0; ///< with a channel off by more than the tolerance
    double failingFraction = 0; ///< of all pixels
};

/// `tolerance`  difference of a channel that a pixel may have, [0, 1] (bytes / 255)
DisplayDifference displayDifference(const DisplayPicture& reference, const DisplayPicture& test, double tolerance);

} // namespace glint::measure
