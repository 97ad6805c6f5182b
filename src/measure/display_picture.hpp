// A picture as a screen shows it: what the metrics of differences between images take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glint::measure {

/// Refers to pixels that someone else keeps.
struct DisplayPicture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::span<const uint8_t> rgb; ///< sRGB, width * height * 3, rows from the top

    size_t pixels() const { return size_t(width) * height; }
};

} // namespace glint::measure
