// Any bytes are a G-buffer file of the promised size with decoded pixels in range, or an error. The first byte chooses
// the mapping.
#include "lab/gbuffer_files/gbuffer_doctor.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace glint::scene;
    if (size < 1)
        return 0;
    static const GBufferMapping kMappings[] = {*readMapping("blender"), *readMapping("glint")};
    const GBufferMapping& mapping = kMappings[data[0] % 2];
    const auto file =
        ExrChannels::decode(std::string(reinterpret_cast<const char*>(data + 1), size - 1), "fuzz.exr", 1 << 14);
    if (!file)
        return 0;
    const auto layers = readLayers(*file, *file, mapping);
    if (!layers)
        return 0;
    Camera camera;
    static_cast<void>(examine(*layers, mapping, camera));
    const auto pixels = decodeLayers(*layers, mapping, camera, "fuzz.exr");
    if (!pixels)
        return 0;
    for (size_t i = 0; i < layers->pixels(); ++i) {
        const float viewZ = pixels->viewZ[i], normal = glm::length(pixels->normalWS[i]);
        if (!(viewZ >= 0 && std::isfinite(viewZ)) || (viewZ > 0 && !(std::abs(normal - 1) < 1e-3f)))
            std::abort();
        for (int c = 0; c < 4; ++c)
            if (!(pixels->material[i][c] >= 0 && pixels->material[i][c] <= 1))
                std::abort();
    }
    return 0;
}
