// A frame of a moving picture as the figures of motion see it: the tested radiance with two seeds, the reference with
// two more, and the roughness band of each pixel.
//
// Two seeds make noise cancel: a product of two errors with independent noise has the systematic error's square as its
// mean (docs/motion.md).
#pragma once

#include "lab/measure/truth/ray_hits.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace glint::measure {

/// RGB of each pixel, linear, clamped to [0, kBrightestRadiance]; NaN stays NaN.
using Radiance = std::shared_ptr<const std::vector<float>>;
constexpr float kBrightestRadiance = 16;

/// `rgba`: four floats per pixel, the fourth ignored.
Radiance radianceOf(std::span<const float> rgba);

/// A RoughnessBand for each reflective pixel; kNoBand for the others.
using PixelBands = std::shared_ptr<const std::vector<uint8_t>>;
constexpr uint8_t kNoBand = 255;
constexpr size_t kBands = kRoughnessBands.size() + 1;

/// `roughness`, `reflectivity`: the views of these names. A pixel is reflective if a channel of its F0 is not 0.
PixelBands pixelBands(std::span<const float> roughness, std::span<const float> reflectivity);

/// A byte per pixel for a mask: 1 where the pixel is in `band`, or reflective at all for kBands.
std::vector<uint8_t> bandMask(const PixelBands& bands, size_t band);

struct MotionFrame {
    uint32_t width = 0;
    uint32_t height = 0;
    std::array<Radiance, 2> test;
    std::array<Radiance, 2> reference; ///< null: none
    PixelBands bands;

    size_t pixels() const { return size_t(width) * height; }
    bool hasReference() const { return reference[0] != nullptr; }
    float testMean(size_t i) const { return 0.5f * ((*test[0])[i] + (*test[1])[i]); }
    float referenceMean(size_t i) const { return 0.5f * ((*reference[0])[i] + (*reference[1])[i]); }
};

/// Sums of several terms by band; index kBands is the sum over all of them.
template <size_t Terms>
class BandSums {
public:
    std::array<double, Terms>& operator[](uint8_t band) { return sums_[band]; }
    std::array<double, Terms> of(size_t band) const {
        if (band < kBands)
            return sums_[band];
        std::array<double, Terms> all = {};
        for (const auto& one : sums_)
            for (size_t i = 0; i < Terms; ++i)
                all[i] += one[i];
        return all;
    }

private:
    std::array<std::array<double, Terms>, kBands> sums_ = {};
};

/// An array with an element for each band and one, the last, for all reflective pixels.
template <class T>
using ByBand = std::array<T, kBands + 1>;

} // namespace glint::measure
