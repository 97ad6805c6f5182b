#include "lab/measure/motion/motion_frame.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace glint::measure {

Radiance radianceOf(std::span<const float> rgba) {
    auto rgb = std::make_shared<std::vector<float>>();
    rgb->reserve(rgba.size() / 4 * 3);
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3)
            rgb->push_back(std::clamp(rgba[i], 0.0f, kBrightestRadiance)); // keeps NaN
    return rgb;
}

PixelBands pixelBands(std::span<const float> roughness, std::span<const float> reflectivity) {
    GLINT_ASSERT(roughness.size() == reflectivity.size(), "{} and {} floats", roughness.size(), reflectivity.size());
    auto bands = std::make_shared<std::vector<uint8_t>>();
    bands->reserve(roughness.size() / 4);
    for (size_t i = 0; i < roughness.size(); i += 4) {
        const bool reflects = reflectivity[i] > 0 || reflectivity[i + 1] > 0 || reflectivity[i + 2] > 0;
        const auto band = std::ranges::upper_bound(kRoughnessBands, roughness[i]) - kRoughnessBands.begin();
        bands->push_back(reflects ? static_cast<uint8_t>(band) : kNoBand);
    }
    return bands;
}

std::vector<uint8_t> bandMask(const PixelBands& bands, size_t band) {
    std::vector<uint8_t> mask(bands->size());
    std::ranges::transform(*bands, mask.begin(), [&](uint8_t of) {
        return static_cast<uint8_t>(of == band || (band == kBands && of != kNoBand));
    });
    return mask;
}

} // namespace glint::measure
