// Builds small binary glTF files, right ones and wrong ones, for the tests of the reader.
#pragma once

#include "lab/scene/gltf/gltf.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace glint::test {

using Json = nlohmann::json;

constexpr int kInt8 = 5120;
constexpr int kUInt8 = 5121;
constexpr int kInt16 = 5122;
constexpr int kUInt16 = 5123;
constexpr int kUInt32 = 5125;
constexpr int kFloat = 5126;

template <class T>
constexpr int componentType() {
    if constexpr (std::is_same_v<T, int8_t>)
        return kInt8;
    else if constexpr (std::is_same_v<T, uint8_t>)
        return kUInt8;
    else if constexpr (std::is_same_v<T, int16_t>)
        return kInt16;
    else if constexpr (std::is_same_v<T, uint16_t>)
        return kUInt16;
    else if constexpr (std::is_same_v<T, uint32_t>)
        return kUInt32;
    else
        return kFloat;
}

inline size_t componentsOf(const std::string& type) {
    return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "MAT4" ? 16 : 4;
}

class GltfBuilder {
public:
    Json json = {{"asset", {{"version", "2.0"}}}};
    std::vector<uint8_t> binary;

    /// A buffer view of these bytes; returns its index.
    template <class T>
    int addView(const std::vector<T>& data, int stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size() * sizeof(T)}};
        if (stride)
            view["byteStride"] = stride;
        const auto* bytes = reinterpret_cast<const uint8_t*>(data.data());
        binary.insert(binary.end(), bytes, bytes + data.size() * sizeof(T));
        return append("bufferViews", view);
    }

    /// An accessor over a view of its own; returns its index.
    template <class T>
    int addAccessor(const std::string& type, const std::vector<T>& components, bool normalized = false) {
        Json accessor = {{"bufferView", addView(components)},
                         {"componentType", componentType<T>()},
                         {"count", components.size() / componentsOf(type)},
                         {"type", type}};
        if (normalized)
            accessor["normalized"] = true;
        return append("accessors", accessor);
    }

    /// Appends to a top-level array; returns the new element's index.
    int append(const std::string& array, const Json& element) {
        json[array].push_back(element);
        return static_cast<int>(json[array].size()) - 1;
    }

    /// One mesh of one primitive, one node and one scene that show it.
    Json& addMesh(const Json& attributes) {
        const int mesh = append("meshes", {{"primitives", {{{"attributes", attributes}}}}});
        const int node = append("nodes", {{"mesh", mesh}});
        json["scenes"] = {{{"nodes", {node}}}};
        return json["meshes"].back()["primitives"][0];
    }

    std::vector<uint8_t> glb() const {
        Json whole = json;
        if (!binary.empty() && !whole.contains("buffers"))
            whole["buffers"] = {{{"byteLength", binary.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::vector<uint8_t> padded = binary;
        padded.resize((padded.size() + 3) / 4 * 4);
        std::vector<uint8_t> out;
        const size_t binaryChunk = padded.empty() ? 0 : 8 + padded.size();
        appendWords(out, {0x46546C67u, 2u, uint32_t(12 + 8 + text.size() + binaryChunk)});
        appendWords(out, {uint32_t(text.size()), 0x4E4F534Au});
        out.insert(out.end(), text.begin(), text.end());
        if (!padded.empty()) {
            appendWords(out, {uint32_t(padded.size()), 0x004E4942u});
            out.insert(out.end(), padded.begin(), padded.end());
        }
        return out;
    }

    Result<scene::Scene> read(const scene::GltfLimits& limits = {}) const {
        return scene::readGltfMemory(glb(), "test.glb", {}, limits);
    }

    /// The message of the error that reading must give, or "read without error".
    std::string readError(const scene::GltfLimits& limits = {}) const {
        const auto scene = read(limits);
        return scene ? "read without error" : scene.error().message;
    }

private:
    static void appendWords(std::vector<uint8_t>& out, std::initializer_list<uint32_t> words) {
        for (const uint32_t word : words)
            for (int shift = 0; shift < 32; shift += 8)
                out.push_back(static_cast<uint8_t>(word >> shift));
    }
};

/// Three corners in the plane z = 0, counter-clockwise.
inline const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

} // namespace glint::test
