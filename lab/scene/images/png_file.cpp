// Writes PNG with stb_image_write: integer arithmetic, so the same pixels give the same bytes on every machine.
#include "base/assert.hpp"
#include "base/file.hpp"
#include "lab/scene/images/image_file.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

namespace glint::scene {

Result<void> writePng(const std::string& path, uint32_t width, uint32_t height, uint32_t channels,
                      std::span<const uint8_t> pixels) {
    GLINT_ASSERT(width > 0 && width <= kMaxImageSide && height > 0 && height <= kMaxImageSide, "{} x {}", width,
                 height);
    GLINT_ASSERT((channels == 3 || channels == 4) && pixels.size() == size_t(width) * height * channels,
                 "{} bytes for {} x {} x {}", pixels.size(), width, height, channels);
    std::string bytes;
    const auto append = [](void* user, void* data, int size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data), size_t(size));
    };
    const int done = stbi_write_png_to_func(append, &bytes, int(width), int(height), int(channels), pixels.data(),
                                            int(width * channels));
    if (!done)
        return makeError(ErrorCode::OutOfMemory, "{}: not enough memory to compress the picture", path);
    return writeFile(path, bytes);
}

} // namespace glint::scene
