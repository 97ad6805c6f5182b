// What a person sees to differ between the images of a comparison: maps of differences, and FLIP.
#pragma once

#include "lab/measure/truth/comparison.hpp"

#include <vector>

namespace glint::measure {

/// A difference of this much of a channel's range, or more, has the brightest colour in ComparisonMaps::difference.
constexpr float kBrightDifference = 0.25f;

/// All maps have the comparison's size; RGB bytes, in the colours of errorColors.
struct ComparisonMaps {
    std::vector<uint8_t> difference; ///< the largest difference of a channel, as a part of kBrightDifference
    std::vector<uint8_t> flip;
    /// The image, dark, with the worst pixels of displayed error (blue), of relative error (orange), or of both
    /// (white); without a reference the image alone.
    std::vector<uint8_t> worst;
    double flipMean = 0;
    std::vector<double> flipMeans; ///< of the further seeds (ConfigFigures::seeds)
};

/// Compares a config's image, as displayed, with the reference's; without a reference, with the first config's.
ComparisonMaps comparisonMaps(const Comparison& comparison, size_t config);

} // namespace glint::measure
