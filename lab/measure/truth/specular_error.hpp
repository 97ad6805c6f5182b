// The reflected light that reaches the eye, as a layer of its own, and its error against a reference by roughness.
#pragma once

#include "lab/measure/motion/motion_frame.hpp"

#include <span>
#include <vector>

namespace glint::measure {

/// Returns composite - lit + weight * fallback: reflected radiance under the material's specular response, without what
/// it replaces. Holds for the physical composite at strength 1. All images have four floats per pixel.
///
/// `weights`   the view of that name: its channels add up to the total weight
/// `fallback`  three floats per pixel; empty: none
std::vector<float> specularLayer(std::span<const float> composite, std::span<const float> lit,
                                 std::span<const float> weights, std::span<const float> fallback);

struct SpecularError {
    uint64_t pixels = 0;
    double relativeMse = 0;
    double psnr = 0;   ///< dB
    double energy = 0; ///< mean of the tested radiance over that of the reference
};

/// Reflective pixels by roughness band (lab/measure/truth/ray_hits.hpp), then all of them. `tested` has four floats per
/// pixel, `reference` three; `roughness` and `reflectivity` are the views of these names.
ByBand<SpecularError> specularError(std::span<const float> tested, std::span<const float> reference,
                                    std::span<const float> roughness, std::span<const float> reflectivity);

} // namespace glint::measure
