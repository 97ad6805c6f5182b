#include "lab/scene/images/jpeg_check.hpp"

#include <cstddef>
#include <numeric>

namespace glint::scene {
namespace {

constexpr uint8_t kHuffmanTables = 0xC4;
constexpr uint8_t kEndOfImage = 0xD9;

/// Markers without a segment: restarts, start of image, and 0xFF00, which is a byte of data.
bool standsAlone(uint8_t marker) {
    return marker == 0x00 || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);
}

bool tablesFit(std::span<const uint8_t> segment) {
    while (!segment.empty()) {
        constexpr size_t kHeader = 17; // class and slot, then the number of codes of each length
        if (segment.size() < kHeader)
            return false;
        const size_t codes = std::accumulate(segment.begin() + 1, segment.begin() + kHeader, size_t(0));
        if (codes > 256 || kHeader + codes > segment.size())
            return false;
        segment = segment.subspan(kHeader + codes);
    }
    return true;
}

} // namespace

bool jpegTablesFit(std::span<const uint8_t> bytes) {
    for (size_t at = 2; at < bytes.size();) {
        if (bytes[at++] != 0xFF) // padding or image data
            continue;
        while (at < bytes.size() && bytes[at] == 0xFF)
            ++at;
        if (at == bytes.size())
            break;
        const uint8_t marker = bytes[at++];
        if (standsAlone(marker))
            continue;
        if (marker == kEndOfImage)
            break;
        if (bytes.size() - at < 2)
            return false;
        const size_t length = size_t(bytes[at]) << 8 | bytes[at + 1];
        if (length < 2 || length > bytes.size() - at)
            return false;
        if (marker == kHuffmanTables && !tablesFit(bytes.subspan(at + 2, length - 2)))
            return false;
        at += length;
    }
    return true;
}

} // namespace glint::scene
