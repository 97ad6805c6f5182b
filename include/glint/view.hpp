// SPDX-License-Identifier: MIT
// The camera that the host rendered a frame with.
#pragma once

#include <array>
#include <cstdint>

namespace glint {

using Matrix4 = std::array<float, 16>; ///< column-major, for column vectors

constexpr Matrix4 kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

struct View {
    Matrix4 worldToView = kIdentity; ///< rigid: its last row is (0, 0, 0, 1)
    Matrix4 viewToClip = kIdentity;  ///< the matrix that made the depth image, with jitter: perspective or orthographic
    uint32_t frameIndex = 0;         ///< changes the noise from frame to frame
    uint32_t seed = 0;               ///< equal seed and frameIndex give bit-identical results
    /// Time since the previous frame of this view: converts settings in seconds to frames. 0: a sixtieth of a second.
    float seconds = 0;
    /// True where the picture does not go on from the previous frame's (another camera, another place): the frame
    /// starts without any history.
    bool cut = false;
    /// The host's frame counter, starting at 1. Glint derives from it which frames the GPU has finished
    /// (ReflectionsDesc::framesInFlight). 0: each call of Reflections::record counts as one frame. Set it if a frame
    /// has several views.
    uint64_t frameNumber = 0;
    /// Extent in use: the pixels that the host drew, from the top left of every image of the frame (backDepth: the same
    /// fraction of its size). It may change with every frame, for dynamic resolution. 0: the whole images.
    uint32_t width = 0;
    uint32_t height = 0;
};

} // namespace glint
