// Writes PNG files with every header field open to the test: bit depths and colour types that no encoder at hand makes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glint::test {

inline void appendU32(std::vector<uint8_t>& out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<uint8_t>(value >> shift));
}

/// `rows` are the unfiltered samples, each row led by its filter byte 0; deflated without compression.
inline std::vector<uint8_t> pngFile(uint32_t width, uint32_t height, uint8_t bitDepth, uint8_t colorType,
                                    const std::vector<uint8_t>& rows) {
    const auto crc = [](const std::vector<uint8_t>& bytes) {
        uint32_t value = ~0u;
        for (const uint8_t byte : bytes) {
            value ^= byte;
            for (int bit = 0; bit < 8; ++bit)
                value = (value >> 1) ^ (value & 1 ? 0xEDB88320u : 0);
        }
        return ~value;
    };
    std::vector<uint8_t> out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    const auto chunk = [&](std::string_view type, const std::vector<uint8_t>& data) {
        std::vector<uint8_t> typed(type.begin(), type.end());
        typed.insert(typed.end(), data.begin(), data.end());
        appendU32(out, static_cast<uint32_t>(data.size()));
        out.insert(out.end(), typed.begin(), typed.end());
        appendU32(out, crc(typed));
    };
    std::vector<uint8_t> header;
    appendU32(header, width);
    appendU32(header, height);
    header.insert(header.end(), {bitDepth, colorType, 0, 0, 0});
    chunk("IHDR", header);

    uint32_t a = 1, b = 0; // Adler-32
    for (const uint8_t byte : rows) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<uint16_t>(rows.size());
    std::vector<uint8_t> stream = {
        0x78, 0x01, 0x01, uint8_t(size), uint8_t(size >> 8), uint8_t(~size), uint8_t(~size >> 8)};
    stream.insert(stream.end(), rows.begin(), rows.end());
    appendU32(stream, b << 16 | a);
    chunk("IDAT", stream);
    chunk("IEND", {});
    return out;
}

} // namespace glint::test
