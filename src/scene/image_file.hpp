// Image files: environments in (.hdr, .exr), pictures out (.png, .exr).
#pragma once

#include "base/result.hpp"
#include "scene/hdr_image.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace glint::scene {

/// The largest side of an image that is read or written, in pixels.
constexpr uint32_t kMaxImageSide = 16384;

/// Reads a Radiance .hdr or an OpenEXR file; what it is, is told from its content.
/// Errors name the file: NotFound, Io, InvalidInput (empty, truncated, something else, larger than 16384 x 8192).
Result<HdrImage> readHdrImage(const std::string& path);

/// Decodes a Radiance picture: flat, old and new run lengths, RGBE. EXPOSURE is ignored, as other readers do.
/// `name` stands in errors; a picture of more than `maxPixels` is an error.
/// Based on: Ward 1991, "Real Pixels", Graphics Gems II; the Radiance file format notes (filefmts.pdf).
Result<HdrImage> decodeRadiance(std::string_view bytes, std::string_view name, uint64_t maxPixels);

/// Decodes an OpenEXR picture with R, G and B channels, unprefixed or in one layer; half, float or uint; scanlines or
/// tiles. The data window is the picture.
Result<HdrImage> decodeExr(std::string_view bytes, std::string_view name, uint64_t maxPixels);

/// Writes 8-bit RGB or RGBA, rows from the top. The same pixels make the same bytes.
/// `channels`  3 or 4; `pixels` has width * height * channels values.
/// Errors: Io.
Result<void> writePng(const std::string& path, uint32_t width, uint32_t height, uint32_t channels,
                      std::span<const uint8_t> pixels);

/// One layer of an EXR file.
struct ExrLayer {
    std::string name;              ///< "" writes the channels bare: R, G, B, A; "depth" writes depth.Z
    std::string channels;          ///< one letter each, in the pixels' order: "RGBA", "RGB", "Z"
    bool half = false;             ///< 16 bits a value, clamped to +-65504; else 32
    std::span<const float> pixels; ///< width * height * stride, rows from the top
    uint32_t stride = 4;           ///< floats from pixel to pixel, >= channels.size(); surplus floats are not written
};

/// Writes one file with all layers, ZIP-compressed, linear. The same pixels make the same bytes.
/// Errors: InvalidArgument when two layers would write the same channel; Io.
Result<void> writeExr(const std::string& path, uint32_t width, uint32_t height, std::span<const ExrLayer> layers);

} // namespace glint::scene
