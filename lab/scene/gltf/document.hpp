// A partly read glTF file: parsed JSON, loaded buffers, checked headers of views and accessors. Every part of the
// reader works on a Document, which is destroyed after reading.
#pragma once

#include "lab/scene/gltf/gltf.hpp"
#include "lab/scene/gltf/json_access.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint::scene::gltf {

/// A range of bytes, after decompression.
struct BufferView {
    std::span<const uint8_t> bytes;
    uint32_t stride = 0; ///< 0: elements are tightly packed
};

/// glTF's numbers for component types.
enum class ComponentType : uint16_t {
    Int8 = 5120,
    UInt8 = 5121,
    Int16 = 5122,
    UInt16 = 5123,
    UInt32 = 5125,
    Float32 = 5126,
};

/// SCALAR is 1 x 1, VEC3 is 3 rows and 1 column, MAT4 is 4 x 4.
struct ElementShape {
    uint32_t rows = 1;
    uint32_t columns = 1;
    uint32_t components() const { return rows * columns; }
    bool operator==(const ElementShape&) const = default;
};

struct SparseAccessor {
    uint64_t count = 0;
    int indicesView = -1;
    uint64_t indicesOffset = 0;
    ComponentType indicesType = ComponentType::UInt32;
    int valuesView = -1;
    uint64_t valuesOffset = 0;
};

struct Accessor {
    int index = -1;      ///< index in the file, for messages
    int bufferView = -1; ///< -1: zeros, or data from an extension
    uint64_t byteOffset = 0;
    uint64_t count = 0;
    ComponentType componentType = ComponentType::Float32;
    ElementShape shape;
    bool normalized = false;
    std::optional<SparseAccessor> sparse;
};

/// Counts the memory that a file's content needs against GltfLimits::sceneBytes, before it is allocated.
class Budget {
public:
    explicit Budget(uint64_t bytes) : left_(bytes) {}
    bool take(uint64_t bytes) {
        if (bytes > left_)
            return false;
        left_ -= bytes;
        return true;
    }

private:
    uint64_t left_;
};

struct Document {
    Document(const std::string& fileName, const GltfLimits& givenLimits)
        : diagnostics(fileName), limits(givenLimits), budget(givenLimits.sceneBytes) {}

    JsonObject root() { return {&json, "", diagnostics}; }
    bool failed() const { return diagnostics.failed(); }

    /// Reserves `bytes` of the budget. Exceeding the budget is an error in the file.
    bool reserve(uint64_t bytes, const std::string& what) {
        if (budget.take(bytes))
            return true;
        diagnostics.fail("{} takes the scene beyond {} MiB, the limit", what, limits.sceneBytes >> 20);
        return false;
    }

    Diagnostics diagnostics;
    GltfLimits limits;
    Budget budget;
    Json json;
    std::optional<std::span<const uint8_t>> binaryChunk;
    UriResolver resolve;

    std::vector<std::vector<uint8_t>> loadedBuffers; ///< owns the data that `buffers` and `views` refer to
    std::vector<std::vector<uint8_t>> decompressedViews;
    std::vector<std::span<const uint8_t>> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
};

} // namespace glint::scene::gltf
