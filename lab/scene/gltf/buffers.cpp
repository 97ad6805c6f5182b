#include "lab/scene/gltf/buffers.hpp"

#include "lab/scene/gltf/meshopt.hpp"
#include "lab/scene/gltf/uri_loading.hpp"

namespace glint::scene::gltf {
namespace {

/// True for a placeholder buffer, whose views have compressed data elsewhere; it may have no bytes.
bool isMeshoptFallback(const JsonObject& buffer) {
    return buffer.extension("EXT_meshopt_compression").boolean("fallback", false);
}

void readBuffer(Document& document, const JsonObject& buffer, size_t index) {
    const uint64_t length = buffer.requiredCount("byteLength");
    std::span<const uint8_t> bytes;
    if (isMeshoptFallback(buffer)) {
        // Never read: all its views must be compressed.
    } else if (buffer.has("uri")) {
        document.loadedBuffers.push_back(loadUri(document, buffer, buffer.string("uri")));
        bytes = document.loadedBuffers.back();
    } else if (index == 0 && document.binaryChunk) {
        bytes = *document.binaryChunk;
    } else {
        document.diagnostics.fail("buffer {} has neither a uri nor a binary chunk", index);
    }
    if (!document.failed() && !isMeshoptFallback(buffer)) {
        if (bytes.size() < length)
            document.diagnostics.fail("buffer {} should have {} bytes but its data has {}", index, length,
                                      bytes.size());
        else
            bytes = bytes.first(length);
    }
    document.buffers.push_back(bytes);
}

/// Returns bytes [byteOffset, byteOffset + byteLength) of a buffer; empty after recording an error.
std::span<const uint8_t> bufferRange(Document& document, const JsonObject& object, size_t viewIndex) {
    const int buffer = object.requiredIndex("buffer", document.buffers.size(), "buffers");
    const uint64_t offset = object.count("byteOffset").value_or(0);
    const uint64_t length = object.requiredCount("byteLength");
    if (document.failed())
        return {};
    const std::span<const uint8_t> bytes = document.buffers[size_t(buffer)];
    if (offset > bytes.size() || length > bytes.size() - offset) {
        document.diagnostics.fail("bufferView {} ends at byte {} but buffer {} has {}", viewIndex, offset + length,
                                  buffer, bytes.size());
        return {};
    }
    return bytes.subspan(offset, length);
}

void readView(Document& document, const JsonObject& object, size_t index) {
    BufferView view;
    const uint64_t stride = object.count("byteStride").value_or(0);
    if (stride > 252 || (object.has("byteStride") && stride < 4)) {
        document.diagnostics.fail("bufferView {} has byteStride {}, which must be between 4 and 252", index, stride);
        return;
    }
    view.stride = static_cast<uint32_t>(stride);
    const JsonObject compressed = object.extension("EXT_meshopt_compression");
    if (compressed.exists()) {
        const std::span<const uint8_t> source = bufferRange(document, compressed, index);
        if (document.failed())
            return;
        document.decompressedViews.push_back(decompressMeshopt(document, compressed, source, index));
        view.bytes = document.decompressedViews.back();
        if (const uint64_t length = object.requiredCount("byteLength");
            !document.failed() && length != view.bytes.size())
            document.diagnostics.fail("bufferView {} should have {} bytes but decompresses to {}", index, length,
                                      view.bytes.size());
    } else {
        view.bytes = bufferRange(document, object, index);
    }
    document.views.push_back(view);
}

} // namespace

void readBuffers(Document& document) {
    const JsonObject root = document.root();
    const std::vector<JsonObject> buffers = root.objects("buffers");
    for (size_t i = 0; i < buffers.size() && !document.failed(); ++i)
        readBuffer(document, buffers[i], i);
    const std::vector<JsonObject> views = root.objects("bufferViews");
    for (size_t i = 0; i < views.size() && !document.failed(); ++i)
        readView(document, views[i], i);
}

} // namespace glint::scene::gltf
