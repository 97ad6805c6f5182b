// Differences of an image from a reference: of radiance, for lighting errors; of bytes, for tests against a stored
// image. flip.hpp measures the visible difference.
#pragma once

#include "lab/measure/figures/display_picture.hpp"

#include <vector>

namespace glint::measure {

/// Returns the mean over pixels and colours of (test - reference)^2 / (reference^2 + 0.01). Radiance is first clamped
/// to [0, 16], so that dark regions count as much as bright ones and no single firefly dominates.
///
/// `reference`, `test`  linear radiance, four floats per pixel, the fourth ignored; of equal, non-zero size
/// `mask`               one byte per pixel, 0: excluded; empty: all pixels count
/// Returns 0 if the mask excludes all pixels; NaN if a counted value is NaN. Based on: Rousselle et al. 2011, "Adaptive
/// Sampling and Reconstruction using Greedy Error Minimization".
double relativeMse(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask = {});

/// Relative errors are of radiance up to this.
constexpr double kBrightestRelative = 16;
/// And of what a display shows: what is brighter than its white is white.
constexpr double kDisplayWhite = 1;

/// Returns the relative squared error of each pixel, the mean of its colours; their mean over the pixels is
/// relativeMse. `brightest`  radiance is clamped to [0, brightest] first
std::vector<double> relativeErrors(std::span<const float> reference, std::span<const float> test, double brightest);

/// The pixels that hold most of an error.
struct WorstPixels {
    double mean = 0;              ///< error of all pixels
    double share = 0;             ///< of the sum of all errors, in these pixels; 0 without errors
    std::vector<uint32_t> pixels; ///< the worst first
};

constexpr double kWorstShare = 0.001; ///< of all pixels

/// Returns the worst kWorstShare of the pixels, at least one. `errors`: relativeErrors, not empty.
WorstPixels worstPixels(std::span<const double> errors);

/// Returns the peak signal-to-noise ratio in dB: 10 log10(1 / mean squared error) with linear radiance clamped to [0,
/// 1], peak 1. Arguments as above. Returns infinity for equal images, and if the mask excludes all pixels; NaN as
/// above.
double psnr(std::span<const float> reference, std::span<const float> test, std::span<const uint8_t> mask = {});

/// Difference of the bytes of two images.
struct DisplayDifference {
    double maxAbsDiff = 0;      ///< largest difference of a channel, [0, 1] (bytes / 255)
    uint64_t failingPixels = 0; ///< pixels with a channel off by more than the tolerance
    double failingFraction = 0; ///< fraction of all pixels
};

/// `tolerance`  accepted difference of a channel, [0, 1] (bytes / 255)
DisplayDifference displayDifference(const DisplayPicture& reference, const DisplayPicture& test, double tolerance);

/// The largest difference of a channel for each pixel, [0, 1] (bytes / 255); rows from the top.
std::vector<float> displayDifferenceMap(const DisplayPicture& reference, const DisplayPicture& test);

} // namespace glint::measure
