// Reads glTF 2.0 files, text or binary, into a Scene. Strict: whatever the bytes are, the answer is a Scene whose every
// index and size is sound, or one line that says what is wrong and where. All of core glTF 2.0 is read, and the
// extensions that gltf/extensions.cpp lists.
#pragma once

#include "base/result.hpp"
#include "scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glint::scene {

/// How much a file may ask for. Small files can describe huge scenes (a solid-colour image, an accessor of zeros, a
/// thousand primitives that share one accessor), so what they make is counted, not only what they are.
struct GltfLimits {
    uint64_t fileBytes = uint64_t(4) << 30;        ///< of the file and of each file beside it
    uint64_t sceneBytes = uint64_t(6) << 30;       ///< decoded images, vertices, animations, together
    uint64_t imagePixels = uint64_t(1) << 27;      ///< of one image, e.g. 16384 x 8192
    uint64_t unbackedElements = uint64_t(1) << 24; ///< of an accessor without bufferView, which is zeros
};

/// Bytes for a relative URI, already percent-decoded. Its errors are passed on as they are.
using UriResolver = std::function<Result<std::vector<uint8_t>>(const std::string& uri)>;

/// Reads `path` (.gltf or .glb, told apart by content) and the buffers and images beside it.
/// Only relative URIs and data URIs are followed. Unsupported optional extensions are one warning a file.
///
/// Errors: NotFound (the file, or one it names), InvalidInput (malformed), Unsupported (a required extension), all
/// beginning with the file's name without its folder.
Result<Scene> readGltf(const std::string& path, const GltfLimits& limits = {});

/// The same from memory. `name` begins every message and becomes Scene::name; `resolve` may be empty.
Result<Scene> readGltfMemory(std::span<const uint8_t> bytes, const std::string& name, const UriResolver& resolve,
                             const GltfLimits& limits = {});

} // namespace glint::scene
