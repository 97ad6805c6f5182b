#include "lab/measure/figures/comparison_maps.hpp"

#include "lab/measure/figures/flip.hpp"
#include "lab/measure/figures/image_error.hpp"

#include <algorithm>

namespace glint::measure {

ComparisonMaps comparisonMaps(const Comparison& comparison, size_t config) {
    const auto picture = [&](const std::vector<uint8_t>& rgb) {
        return DisplayPicture{comparison.width, comparison.height, rgb};
    };
    const DisplayPicture base = picture(comparison.referencePicture.empty() ? comparison.configs.front().composite
                                                                            : comparison.referencePicture);
    const ConfigFigures& figures = comparison.configs[config];
    ComparisonMaps maps;
    std::vector<float> difference = displayDifferenceMap(base, picture(figures.composite));
    std::ranges::transform(difference, difference.begin(),
                           [](float value) { return std::min(value / kBrightDifference, 1.0f); });
    maps.difference = errorColors(difference);
    const FlipMap map = flip(base, picture(figures.composite));
    maps.flip = errorColors(map.error);
    maps.flipMean = map.mean;
    for (const SeedFigures& seed : figures.seeds)
        maps.flipMeans.push_back(flip(base, picture(seed.composite)).mean);
    return maps;
}

} // namespace glint::measure
