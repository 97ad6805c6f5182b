#include "lab/scene/images/image_decode.hpp"

#include "lab/scene/images/jpeg_check.hpp"

#include <webp/decode.h>

// stb_image is compiled only here.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

namespace glint::scene {
namespace {

enum class Format { Unknown, Png, Jpeg, WebP, Ktx2 };

bool beginsWith(std::span<const uint8_t> bytes, std::string_view signature, size_t at = 0) {
    return bytes.size() >= at + signature.size() &&
           std::memcmp(bytes.data() + at, signature.data(), signature.size()) == 0;
}

Format detectFormat(std::span<const uint8_t> bytes) {
    if (beginsWith(bytes, "\x89PNG\r\n\x1a\n"))
        return Format::Png;
    if (beginsWith(bytes, "\xff\xd8\xff"))
        return Format::Jpeg;
    if (beginsWith(bytes, "RIFF") && beginsWith(bytes, "WEBP", 8))
        return Format::WebP;
    if (beginsWith(bytes, "\xabKTX 20\xbb\r\n\x1a\n"))
        return Format::Ktx2;
    return Format::Unknown;
}

struct Size {
    int width = 0;
    int height = 0;
};

Result<Size> readSize(std::span<const uint8_t> bytes, Format format, const std::string& name) {
    Size size;
    int channels = 0;
    const bool ok = format == Format::WebP ? WebPGetInfo(bytes.data(), bytes.size(), &size.width, &size.height) != 0
                                           : stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()),
                                                                   &size.width, &size.height, &channels) != 0;
    if (!ok || size.width <= 0 || size.height <= 0)
        return invalidInput("{}: the image's header is damaged", name);
    return size;
}

/// Returns the most pixels that a valid file of this size can contain: deflate repeats a byte at most 1032 times; a
/// JPEG block of 64 pixels takes at least one bit in its first scan. More is rejected before allocation. WebP needs no
/// bits for a single colour, so only the pixel limit applies.
uint64_t mostPixels(std::span<const uint8_t> bytes, Format format) {
    switch (format) {
    case Format::Png: return bytes.size() * uint64_t(1032) * 8; // 1-bit grey
    case Format::Jpeg: return bytes.size() * uint64_t(64) * 8 * 4;
    default: return std::numeric_limits<uint64_t>::max();
    }
}

bool decodeWith(std::span<const uint8_t> bytes, Format format, Image& image) {
    if (format == Format::WebP) {
        const int stride = static_cast<int>(image.width * 4);
        return WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(), stride) != nullptr;
    }
    Size size;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &size.width, &size.height, &channels, 4),
        &stbi_image_free);
    if (!pixels || uint32_t(size.width) != image.width || uint32_t(size.height) != image.height)
        return false;
    std::copy_n(pixels.get(), image.rgba.size(), image.rgba.begin());
    return true;
}

} // namespace

Result<Image> decodeImage(std::span<const uint8_t> bytes, const std::string& name, uint64_t maxPixels) {
    const Format format = detectFormat(bytes);
    if (format == Format::Ktx2)
        return makeError(ErrorCode::Unsupported, "{}: is a KTX2 image; only PNG, JPEG and WebP can be read", name);
    if (format == Format::Unknown)
        return invalidInput("{}: is no PNG, JPEG or WebP image{}", name, bytes.empty() ? " (0 bytes)" : "");
    if (bytes.size() > size_t(std::numeric_limits<int>::max()))
        return invalidInput("{}: has {} bytes, more than an image file may have (2 GiB)", name, bytes.size());
    if (format == Format::Jpeg && !jpegTablesFit(bytes))
        return invalidInput("{}: the JPEG's tables are damaged or cut off", name);
    GLINT_TRY(size, readSize(bytes, format, name));
    const uint64_t pixels = uint64_t(size.width) * uint64_t(size.height);
    if (size.width > STBI_MAX_DIMENSIONS || size.height > STBI_MAX_DIMENSIONS || pixels > maxPixels)
        return invalidInput("{}: is {} x {} pixels; at most {} a side and {} in all can be read", name, size.width,
                            size.height, STBI_MAX_DIMENSIONS, maxPixels);
    if (pixels > mostPixels(bytes, format))
        return invalidInput("{}: claims {} x {} pixels, more than its {} bytes can hold", name, size.width, size.height,
                            bytes.size());

    Image image;
    image.name = name;
    image.width = static_cast<uint32_t>(size.width);
    image.height = static_cast<uint32_t>(size.height);
    image.rgba.resize(pixels * 4);
    if (!decodeWith(bytes, format, image))
        return invalidInput("{}: the image is damaged or cut off", name);
    return image;
}

} // namespace glint::scene
