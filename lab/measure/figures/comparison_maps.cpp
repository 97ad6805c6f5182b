#include "lab/measure/figures/comparison_maps.hpp"

#include "lab/measure/figures/flip.hpp"
#include "lab/measure/figures/image_error.hpp"

#include <algorithm>
#include <array>

namespace glint::measure {

namespace {

std::vector<uint8_t> worstMap(const Comparison& comparison, const ConfigFigures& figures) {
    constexpr int kAround = 1; // pixels: single ones would be hard to find
    constexpr int kDark = 4;
    std::vector<uint8_t> map = figures.composite;
    std::ranges::transform(map, map.begin(), [](uint8_t value) { return static_cast<uint8_t>(value / kDark); });
    if (!figures.reference)
        return map;
    std::vector<uint8_t> marks(size_t(comparison.width) * comparison.height);
    const auto mark = [&](const WorstPixels& worst, uint8_t bit) {
        for (const uint32_t pixel : worst.pixels)
            for (int dy = -kAround; dy <= kAround; ++dy)
                for (int dx = -kAround; dx <= kAround; ++dx) {
                    const int64_t x = int64_t(pixel % comparison.width) + dx;
                    const int64_t y = int64_t(pixel / comparison.width) + dy;
                    if (x >= 0 && y >= 0 && x < comparison.width && y < comparison.height)
                        marks[static_cast<size_t>(y) * comparison.width + static_cast<size_t>(x)] |= bit;
                }
    };
    mark(figures.reference->displayed, 1);
    mark(figures.reference->radiance, 2);
    constexpr std::array<std::array<uint8_t, 3>, 4> kColors = {{{}, {70, 140, 255}, {255, 140, 30}, {255, 255, 255}}};
    for (size_t i = 0; i < marks.size(); ++i)
        if (marks[i] != 0)
            std::ranges::copy(kColors[marks[i]], map.begin() + static_cast<std::ptrdiff_t>(3 * i));
    return map;
}

} // namespace

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
    maps.worst = worstMap(comparison, figures);
    for (const SeedFigures& seed : figures.seeds)
        maps.flipMeans.push_back(flip(base, picture(seed.composite)).mean);
    return maps;
}

} // namespace glint::measure
