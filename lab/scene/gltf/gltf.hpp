// Reads glTF 2.0 files, text or binary, into a Scene. Strict: for any input, the result is either a Scene whose indices
// and sizes are all valid, or a one-line error with cause and position. Supports all of core glTF 2.0, and the
// extensions that gltf/extensions.cpp lists.
#pragma once

#include "base/result.hpp"
#include "lab/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace glint::scene {

/// Resource limits for one file. Small files can describe huge scenes (a solid-colour image, an accessor of zeros, a
/// thousand primitives that share one accessor), so the decoded data are limited as well as the file size.
struct GltfLimits {
    uint64_t fileBytes = uint64_t(4) << 30;        ///< of the file, and of each file that it refers to
    uint64_t sceneBytes = uint64_t(6) << 30;       ///< decoded images, vertices and animations together
    uint64_t imagePixels = uint64_t(1) << 27;      ///< per image, e.g. 16384 x 8192
    uint64_t unbackedElements = uint64_t(1) << 24; ///< of an accessor without bufferView, which contains zeros
};

/// Returns the bytes for a relative URI, which is already percent-decoded. Its errors are returned unchanged.
using UriResolver = std::function<Result<std::vector<uint8_t>>(const std::string& uri)>;

/// Reads `path` (.gltf or .glb, distinguished by content) and the buffers and images beside it. Only relative URIs and
/// data URIs are followed. Unsupported optional extensions cause one warning per file.
///
/// Errors: NotFound (the file, or one that it names), InvalidInput (malformed), Unsupported (a required extension). All
/// messages begin with the file's name without its folder.
Result<Scene> readGltf(const std::string& path, const GltfLimits& limits = {});

/// As readGltf, from memory. `name` begins every message and becomes Scene::name; `resolve` may be empty.
Result<Scene> readGltfMemory(std::span<const uint8_t> bytes, const std::string& name, const UriResolver& resolve,
                             const GltfLimits& limits = {});

} // namespace glint::scene
