#include "lab/scene/images/webp_writer.hpp"

#include "base/assert.hpp"

#include <webp/encode.h>

namespace glint::scene {

Result<std::string> encodeWebp(uint32_t width, uint32_t height, std::span<const uint8_t> rgb,
                               std::optional<float> quality) {
    GLINT_ASSERT(rgb.size() == size_t(width) * height * 3, "{} bytes for {}x{}", rgb.size(), width, height);
    if (width < 1 || height < 1 || width > WEBP_MAX_DIMENSION || height > WEBP_MAX_DIMENSION)
        return invalidArgument("WebP stores images of 1 to {} pixels a side, not {}x{}", WEBP_MAX_DIMENSION, width,
                               height);
    uint8_t* bytes = nullptr;
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    const size_t size = quality ? WebPEncodeRGB(rgb.data(), w, h, 3 * w, *quality, &bytes)
                                : WebPEncodeLosslessRGB(rgb.data(), w, h, 3 * w, &bytes);
    std::string file;
    if (bytes != nullptr) {
        file.assign(bytes, bytes + size);
        WebPFree(bytes);
    }
    return size > 0 ? Result<std::string>(std::move(file))
                    : makeError(ErrorCode::OutOfMemory, "an image of {}x{} could not be encoded", width, height);
}

} // namespace glint::scene
