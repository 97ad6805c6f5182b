// The error of an image against a reference: over all pixels, over mirrors, and by roughness.
#pragma once

#include "lab/measure/figures/image_error.hpp"
#include "lab/measure/motion/motion_frame.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace glint::measure {

/// Pixels up to this perceptual roughness count as mirrors: their reflections are no wider than about a pixel.
constexpr float kMirrorRoughness = 0.01f;

/// Of the pixels of a roughness band.
struct BandError {
    uint64_t pixels = 0;
    double relativeMse = 0;
};

struct ReferenceError {
    double psnr = 0;        ///< dB, of all pixels (measure::psnr)
    double psnrMirrors = 0; ///< dB, of mirrors: reflective pixels with perceptual roughness up to kMirrorRoughness
    double relativeMse = 0; ///< of all pixels
    double relativeMseMirrors = 0;
    WorstPixels displayed; ///< relative squared error of what a display shows: radiance up to its white
    WorstPixels radiance;  ///< the same of radiance: its mean is relativeMse
    uint64_t mirrorPixels = 0;
    ByBand<BandError> bands =
        {}; ///< reflective pixels; their limits are those of the hits (lab/measure/truth/ray_hits.hpp)
};

class ReferencePicture {
public:
    ReferencePicture() = default;
    /// All images have four floats per pixel and one size: linear radiance, and the views "roughness" and
    /// "reflectivity".
    ReferencePicture(std::vector<float> radiance, std::span<const float> roughness,
                     std::span<const float> reflectivity);

    /// `picture`: linear radiance, of the same size.
    ReferenceError errorOf(std::span<const float> picture) const;

private:
    std::vector<float> radiance_;
    std::vector<uint8_t> mirrors_; ///< of the reference's pixels
    PixelBands bands_;
};

} // namespace glint::measure
