// The error of an image against a reference, over all pixels and over mirrors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace glint::measure {

/// Pixels up to this perceptual roughness count as mirrors: their reflections are no wider than about a pixel.
constexpr float kMirrorRoughness = 0.01f;

struct ReferenceError {
    double psnr = 0;        ///< dB, of all pixels (measure::psnr)
    double psnrMirrors = 0; ///< dB, of mirrors: reflective pixels with perceptual roughness up to kMirrorRoughness
    double relativeMse = 0; ///< of all pixels
    double relativeMseMirrors = 0;
    uint64_t mirrorPixels = 0;
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
};

} // namespace glint::measure
