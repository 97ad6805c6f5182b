#include "lab/scene/gltf/gltf.hpp"

#include "lab/scene/gltf/accessor.hpp"
#include "lab/scene/gltf/animations.hpp"
#include "lab/scene/gltf/buffers.hpp"
#include "lab/scene/gltf/container.hpp"
#include "lab/scene/gltf/extensions.hpp"
#include "lab/scene/gltf/lenses_lights.hpp"
#include "lab/scene/gltf/materials.hpp"
#include "lab/scene/gltf/meshes.hpp"
#include "lab/scene/gltf/nodes.hpp"
#include "lab/scene/gltf/textures.hpp"

#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>

namespace glint::scene {
namespace {

namespace fs = std::filesystem;

/// Reads a whole regular file. `label` is its name in messages.
Result<std::vector<uint8_t>> readFile(const fs::path& path, const std::string& label, uint64_t maxBytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        return makeError(ErrorCode::NotFound, "{}: no such file", label);
    if (fs::is_directory(status))
        return invalidInput("{}: is a folder, not a file", label);
    if (!fs::is_regular_file(status))
        return invalidInput("{}: is not a regular file", label);
    const uintmax_t size = fs::file_size(path, error);
    if (error || size > maxBytes)
        return invalidInput("{}: is larger than {} MiB, the limit", label, maxBytes >> 20);
    std::ifstream file(path, std::ios::binary);
    std::vector<uint8_t> bytes(size);
    if (!file || !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
        return makeError(ErrorCode::Io, "{}: cannot be read", label);
    return bytes;
}

/// Reads the parts in the order of their dependencies.
void readParts(gltf::Document& document, Scene& scene) {
    using Part = void (*)(gltf::Document&, Scene&);
    constexpr Part kParts[] = {gltf::readTextures, gltf::readMaterials, gltf::readCameras,   gltf::readLights,
                               gltf::readMeshes,   gltf::readNodes,     gltf::readAnimations};
    gltf::checkVersionAndExtensions(document);
    if (!document.failed())
        gltf::readBuffers(document);
    if (!document.failed())
        gltf::readAccessors(document);
    for (const Part part : kParts)
        if (!document.failed())
            part(document, scene);
}

Result<Scene> readDocument(std::span<const uint8_t> bytes, const std::string& name, const UriResolver& resolve,
                           const GltfLimits& limits) {
    GLINT_TRY(container, gltf::openContainer(bytes, name));
    GLINT_TRY(json, gltf::parseJson(container.json, name));
    gltf::Document document(name, limits);
    document.json = std::move(json);
    document.binaryChunk = container.binary;
    document.resolve = resolve;

    Scene scene;
    scene.name = name;
    readParts(document, scene);
    if (document.failed())
        return document.diagnostics.error();
    return scene;
}

} // namespace

Result<Scene> readGltfMemory(std::span<const uint8_t> bytes, const std::string& name, const UriResolver& resolve,
                             const GltfLimits& limits) {
    // Only the standard library and Draco throw here, when memory runs out.
    try {
        return readDocument(bytes, name, resolve, limits);
    } catch (const std::bad_alloc&) {
        return makeError(ErrorCode::OutOfMemory, "{}: there is not enough memory to read it", name);
    } catch (const std::length_error&) {
        return makeError(ErrorCode::OutOfMemory, "{}: there is not enough memory to read it", name);
    }
}

Result<Scene> readGltf(const std::string& path, const GltfLimits& limits) {
    const fs::path file(path);
    const std::string name = file.filename().empty() ? path : file.filename().string();
    GLINT_TRY(bytes, readFile(file, name, limits.fileBytes));
    const auto resolve = [&](const std::string& uri) {
        return readFile(file.parent_path() / uri, fmt::format("\"{}\"", uri), limits.fileBytes);
    };
    return readGltfMemory(bytes, name, resolve, limits);
}

} // namespace glint::scene
