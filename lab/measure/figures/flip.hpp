// The visible difference of two images to a person who flips between them. It does not determine which image is right.
// Its input is displayed colour, after exposure and tone mapping, not radiance.
#pragma once

#include "lab/measure/figures/display_picture.hpp"

#include <vector>

namespace glint::measure {

/// The observer of DESIGN's figures: a screen 0.7 m wide with 3840 pixels, seen from 0.7 m, has 67.02.
constexpr double kFlipPixelsPerDegree = 67;

struct FlipMap {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> error; ///< [0, 1] each, 0: no visible difference; rows from the top
    double mean = 0;          ///< over all pixels
};

/// Compares two images of the same size, at least 1 x 1. Symmetric; equal images give exactly 0 everywhere. Black
/// against white is 0.967; only saturated green against saturated blue reaches 1.
///
/// `pixelsPerDegree`  of visual angle, > 0: larger means farther away, and finer differences vanish. Cost grows with it
/// Threading: any. The same images give the same bits on one machine; the last digits depend on the mathematics
/// library. Based on: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", PACMCGIT 3(2):
/// LDR-FLIP.
FlipMap flip(const DisplayPicture& reference, const DisplayPicture& test,
             double pixelsPerDegree = kFlipPixelsPerDegree);

/// Returns display colours as RGB bytes, from black (0) through purple and orange to pale yellow (1). NaN is black.
std::vector<uint8_t> errorColors(std::span<const float> error);

} // namespace glint::measure
