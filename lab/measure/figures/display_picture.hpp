// An image as displayed: the input of image difference metrics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glint::measure {

/// Does not own the pixels.
struct DisplayPicture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::span<const uint8_t> rgb; ///< sRGB, width * height * 3, rows from the top

    size_t pixels() const { return size_t(width) * height; }
};

} // namespace glint::measure
