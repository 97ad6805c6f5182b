#include "lab/measure/truth/specular_error.hpp"

#include "base/assert.hpp"
#include "lab/measure/figures/image_error.hpp"

#include <algorithm>

namespace glint::measure {

std::vector<float> specularLayer(std::span<const float> composite, std::span<const float> lit,
                                 std::span<const float> weights, std::span<const float> fallback) {
    GLINT_ASSERT(composite.size() == lit.size() && lit.size() == weights.size(), "{}, {} and {} floats",
                 composite.size(), lit.size(), weights.size());
    std::vector<float> layer(composite.size());
    for (size_t i = 0; i < layer.size(); i += 4) {
        const float weight = std::min(weights[i] + weights[i + 1] + weights[i + 2] + weights[i + 3], 1.0f);
        for (size_t c = 0; c < 3; ++c)
            layer[i + c] = composite[i + c] - lit[i + c] + (fallback.empty() ? 0.0f : weight * fallback[i / 4 * 3 + c]);
        layer[i + 3] = weight;
    }
    return layer;
}

ByBand<SpecularError> specularError(std::span<const float> tested, std::span<const float> reference,
                                    std::span<const float> roughness, std::span<const float> reflectivity) {
    std::vector<float> wide(tested.size());
    for (size_t i = 0; i < tested.size() / 4; ++i)
        std::copy_n(reference.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    wide.begin() + static_cast<std::ptrdiff_t>(4 * i));
    const PixelBands bands = pixelBands(roughness, reflectivity);
    ByBand<SpecularError> errors;
    for (size_t band = 0; band <= kBands; ++band) {
        const std::vector<uint8_t> mask = bandMask(bands, band);
        SpecularError& error = errors[band];
        error.pixels = static_cast<uint64_t>(std::ranges::count(mask, uint8_t{1}));
        if (error.pixels == 0)
            continue;
        error.relativeMse = relativeMse(wide, tested, mask);
        error.psnr = psnr(wide, tested, mask);
        double testedSum = 0, referenceSum = 0;
        for (size_t i = 0; i < tested.size(); ++i)
            if (i % 4 != 3 && mask[i / 4] != 0) {
                testedSum += std::clamp<double>(tested[i], 0, kBrightestRadiance);
                referenceSum += std::clamp<double>(wide[i], 0, kBrightestRadiance);
            }
        error.energy = referenceSum > 0 ? testedSum / referenceSum : 0;
    }
    return errors;
}

} // namespace glint::measure
