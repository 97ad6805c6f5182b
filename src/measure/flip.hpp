// How different two pictures look to a person who flips between them. It says nothing about which one is right, and it
// is not for radiance: exposure and tone map have been applied before.
#pragma once

#include "measure/display_picture.hpp"

#include <vector>

namespace glint::measure {

/// The observer of DESIGN's figures: a screen 0.7 m wide with 3840 pixels, seen from 0.7 m, has 67.02.
constexpr double kFlipPixelsPerDegree = 67;

struct FlipMap {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> error; ///< [0, 1] each, 0: no difference can be seen; rows from the top
    double mean = 0;          ///< over all pixels
};

/// Compares two pictures of the same size, at least 1 x 1. Symmetric; equal pictures give exactly 0 everywhere. Black
/// against white is 0.967: the scale ends where only saturated green against saturated blue gets.
///
/// `pixelsPerDegree`  of visual angle, > 0: larger is farther away, and finer differences vanish. Work grows with it
/// Threading: any. The same pictures give the same bits on one machine; the last digits are the mathematics library's.
/// Based on: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images", PACMCGIT 3(2): LDR-FLIP.
FlipMap flip(const DisplayPicture& reference, const DisplayPicture& test,
             double pixelsPerDegree = kFlipPixelsPerDegree);

/// Colours for people, from black (0) through purple and orange to pale yellow (1): RGB bytes. NaN is black.
std::vector<uint8_t> errorColors(std::span<const float> error);

} // namespace glint::measure
