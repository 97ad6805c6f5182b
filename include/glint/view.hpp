// A camera as the host rendered with it.
#pragma once

#include <array>
#include <cstdint>

namespace glint {

using Matrix4 = std::array<float, 16>; ///< column-major, for column vectors

constexpr Matrix4 kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

struct View {
    Matrix4 worldToView = kIdentity; ///< rigid
    Matrix4 viewToClip = kIdentity;  ///< exactly as used for depth: perspective or orthographic, jitter included
    uint32_t frameIndex = 0;         ///< moves the noise from frame to frame
    uint32_t seed = 0;               ///< the same seed and frame give the same bits
};

} // namespace glint
