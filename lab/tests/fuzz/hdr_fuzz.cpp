// Any bytes are a Radiance picture of the promised size with finite values, or an error.
#include "lab/scene/images/image_file.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto image = glint::scene::decodeRadiance(bytes, "fuzz.hdr", 1 << 18);
    if (!image)
        return 0;
    if (image->rgb.size() != size_t(image->width) * image->height)
        std::abort();
    for (const glm::vec3& pixel : image->rgb) {
        for (int i = 0; i < 3; ++i) {
            if (!(pixel[i] >= 0 && pixel[i] <= 1e12f))
                std::abort();
        }
    }
    return 0;
}
