// Any bytes are a Scene that can be posed, or one line of error: no crash, no endless loop, no memory beyond the
// limits.
#include "base/log.hpp"
#include "lab/scene/gltf/gltf.hpp"
#include "lab/scene/pose.hpp"

#include <cstdlib>

using namespace glint;

namespace {

/// What the reader promises about every scene it returns.
void require(bool promise) {
    if (!promise)
        std::abort();
}

void checkScene(const scene::Scene& scene) {
    for (const scene::Mesh& mesh : scene.meshes) {
        for (const scene::Primitive& primitive : mesh.primitives) {
            const scene::Geometry& geometry = primitive.geometry;
            const size_t vertices = geometry.positions.size();
            for (const uint32_t index : geometry.indices)
                require(index < vertices);
            require(geometry.normals.empty() || geometry.normals.size() == vertices);
            require(geometry.tangents.empty() || geometry.tangents.size() == vertices);
            require(primitive.morphTargets.size() == mesh.weights.size());
        }
    }
    for (const scene::Texture& texture : scene.textures)
        require(texture.image < static_cast<int>(scene.images.size()));
    for (const double time : {0.0, 0.4, 1e9})
        for (int i = 0; i < static_cast<int>(scene.scenes.size()); ++i)
            require(scene::pose(scene, time, i).ok());
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    log::setSink([](std::string_view, void*) {}, nullptr);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    scene::GltfLimits limits;
    limits.sceneBytes = uint64_t(32) << 20;
    limits.imagePixels = uint64_t(1) << 20;
    limits.unbackedElements = 1 << 16;
    // A file beside the model is the model itself, so that external buffers and images have bytes to mutate.
    const auto resolve = [&](const std::string&) -> Result<std::vector<uint8_t>> {
        return std::vector<uint8_t>(data, data + size);
    };
    const auto scene = scene::readGltfMemory({data, size}, "fuzz", resolve, limits);
    if (scene)
        checkScene(*scene);
    else
        require(scene.error().message.find('\n') == std::string::npos);
    return 0;
}
