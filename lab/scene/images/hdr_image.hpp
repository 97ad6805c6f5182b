// An image of radiance: the content of an environment file.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace glint::scene {

struct HdrImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> rgb; ///< linear, finite, [0, 1e12]; width * height, rows from the top
};

/// The largest finite half float, which the GPU's images can store. Suns exceed it.
constexpr float kMaxRadiance = 65504;

/// Converts a value from a file for HdrImage: NaN and negative numbers become 0. Infinity is what a half has for a sun
/// that it cannot hold, of which nothing is known but that it is brighter than the largest half.
inline float asEnvironmentRadiance(float value) {
    constexpr float kLargest = 1e12f; // sums stay finite
    if (value == std::numeric_limits<float>::infinity())
        return kMaxRadiance;
    return value > 0 ? glm::min(value, kLargest) : 0.0f;
}

/// Converts radiance for the GPU's images: NaN and negative numbers become 0.
inline float asRadiance(float value) {
    return value > 0 ? glm::min(value, kMaxRadiance) : 0.0f;
}

} // namespace glint::scene
