#include "lab/scene/gltf/container.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint::scene::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and so is this reader");

constexpr uint32_t kMagic = 0x46546C67;     // "glTF"
constexpr uint32_t kChunkJson = 0x4E4F534A; // "JSON"
constexpr uint32_t kChunkBin = 0x004E4942;  // "BIN\0"
constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;

uint32_t readU32(std::span<const uint8_t> bytes, size_t at) {
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

Result<Container> openBinary(std::span<const uint8_t> bytes, const std::string& fileName) {
    if (bytes.size() < kHeaderBytes)
        return invalidInput("{}: is cut off: a binary glTF begins with {} bytes, the file has {}", fileName,
                            kHeaderBytes, bytes.size());
    if (const uint32_t version = readU32(bytes, 4); version != 2)
        return invalidInput("{}: is binary glTF version {}, only version 2 can be read", fileName, version);
    const uint32_t length = readU32(bytes, 8);
    if (length > bytes.size())
        return invalidInput("{}: is cut off: its header says {} bytes, the file has {}", fileName, length,
                            bytes.size());

    Container container;
    bool first = true;
    for (size_t at = kHeaderBytes; at < length; first = false) {
        if (length - at < kChunkHeaderBytes)
            return invalidInput("{}: is cut off in the header of the chunk at byte {}", fileName, at);
        const uint32_t chunkLength = readU32(bytes, at);
        const uint32_t type = readU32(bytes, at + 4);
        at += kChunkHeaderBytes;
        if (chunkLength > length - at)
            return invalidInput("{}: the chunk at byte {} has {} bytes but the file ends after {}", fileName,
                                at - kChunkHeaderBytes, chunkLength, length - at);
        const auto chunk = bytes.subspan(at, chunkLength);
        if (first && type != kChunkJson)
            return invalidInput("{}: the first chunk is not JSON", fileName);
        if (first)
            container.json = chunk;
        else if (type == kChunkBin && !container.binary)
            container.binary = chunk;
        at += chunkLength; // other chunk types must be skipped (specification)
    }
    if (first)
        return invalidInput("{}: has no JSON chunk", fileName);
    return container;
}

} // namespace

Result<Container> openContainer(std::span<const uint8_t> bytes, const std::string& fileName) {
    if (bytes.empty())
        return invalidInput("{}: is empty (0 bytes)", fileName);
    if (bytes.size() >= 4 && readU32(bytes, 0) == kMagic)
        return openBinary(bytes, fileName);
    constexpr uint8_t kByteOrderMark[] = {0xEF, 0xBB, 0xBF}; // forbidden by the specification, written by some editors
    if (bytes.size() >= 3 && std::equal(std::begin(kByteOrderMark), std::end(kByteOrderMark), bytes.begin()))
        bytes = bytes.subspan(3);
    const auto text = std::find_if(bytes.begin(), bytes.end(),
                                   [](uint8_t c) { return c != ' ' && c != '\t' && c != '\r' && c != '\n'; });
    if (text == bytes.end() || *text != '{')
        return invalidInput("{}: is not glTF: it begins neither with \"glTF\" (binary) nor with {{ (JSON)", fileName);
    return Container{bytes, std::nullopt};
}

} // namespace glint::scene::gltf
