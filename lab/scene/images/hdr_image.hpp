// An image of radiance: the content of an environment file.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace glint::scene {

struct HdrImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> rgb; ///< linear, finite, [0, 65504]; width * height, rows from the top
};

/// The largest finite half float, which the GPU's images can store. Suns in files exceed it, or are infinite.
constexpr float kMaxRadiance = 65504;

/// Converts a value from a file for HdrImage: NaN and negative numbers become 0.
inline float asRadiance(float value) {
    return value > 0 ? glm::min(value, kMaxRadiance) : 0.0f;
}

} // namespace glint::scene
