// Image files: reads environments (.hdr, .exr), writes images (.png, .exr).
#pragma once

#include "base/result.hpp"
#include "lab/scene/images/hdr_image.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace glint::scene {

/// Maximum side length of an image that is read or written, in pixels.
constexpr uint32_t kMaxImageSide = 16384;

/// Reads a Radiance .hdr or an OpenEXR file; the format is determined from the content. Errors name the file: NotFound,
/// Io, InvalidInput (empty, truncated, another format, larger than 16384 x 8192).
Result<HdrImage> readHdrImage(const std::string& path);

/// Decodes a Radiance image: flat, old and new run lengths, RGBE. EXPOSURE is ignored, as other readers do. `name` is
/// used in error messages; an image of more than `maxPixels` is an error. Based on: Ward 1991, "Real Pixels", Graphics
/// Gems II; the Radiance file format notes (filefmts.pdf).
Result<HdrImage> decodeRadiance(std::string_view bytes, std::string_view name, uint64_t maxPixels);

/// Decodes an OpenEXR image with R, G and B channels, unprefixed or in one layer; half, float or uint; scanlines or
/// tiles. The image is the data window.
Result<HdrImage> decodeExr(std::string_view bytes, std::string_view name, uint64_t maxPixels);

/// Writes 8-bit RGB or RGBA, rows from the top. The same pixels make the same bytes.
/// `channels`  3 or 4; `pixels` has width * height * channels values.
/// Errors: Io.
Result<void> writePng(const std::string& path, uint32_t width, uint32_t height, uint32_t channels,
                      std::span<const uint8_t> pixels);

/// One layer of an EXR file.
struct ExrLayer {
    std::string name;              ///< "" writes the channels without a prefix: R, G, B, A; "depth" writes depth.Z
    std::string channels;          ///< one letter each, in the pixels' order: "RGBA", "RGB", "Z"
    bool half = false;             ///< 16 bits per value, clamped to +-65504; false: 32 bits
    std::span<const float> pixels; ///< width * height * stride, rows from the top
    uint32_t stride = 4; ///< floats from one pixel to the next, >= channels.size(); surplus floats are not written
};

/// Writes one file with all layers, ZIP-compressed, linear. The same pixels make the same bytes. Errors:
/// InvalidArgument if two layers would write the same channel; Io.
Result<void> writeExr(const std::string& path, uint32_t width, uint32_t height, std::span<const ExrLayer> layers);

} // namespace glint::scene
