#include "lab/scene/gltf/uri.hpp"

#include <algorithm>
#include <array>

namespace glint::scene::gltf {
namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    return -1;
}

std::string percentDecode(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0) {
            result.push_back(static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])));
            i += 2;
        } else {
            result.push_back(text[i]);
        }
    }
    return result;
}

constexpr std::array<int, 256> makeBase64Values() {
    std::array<int, 256> values{};
    values.fill(-1);
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < kAlphabet.size(); ++i)
        values[static_cast<uint8_t>(kAlphabet[i])] = static_cast<int>(i);
    return values;
}

Result<std::vector<uint8_t>> decodeBase64(std::string_view text) {
    static constexpr std::array<int, 256> kValues = makeBase64Values();
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    if (text.size() % 4 == 1)
        return invalidInput("a data URI's base64 is cut off");
    std::vector<uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int bitCount = 0;
    for (const char c : text) {
        const int value = kValues[static_cast<uint8_t>(c)];
        if (value < 0)
            return invalidInput("a data URI has the character 0x{:02x}, which base64 does not know",
                                static_cast<uint8_t>(c));
        bits = (bits << 6) | static_cast<uint32_t>(value);
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<uint8_t>(bits >> bitCount));
        }
    }
    return bytes;
}

} // namespace

bool isDataUri(std::string_view uri) {
    return uri.starts_with("data:");
}

Result<std::vector<uint8_t>> decodeDataUri(std::string_view uri) {
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        return invalidInput("a data URI has no comma before its data");
    const std::string_view data = uri.substr(comma + 1);
    if (uri.substr(0, comma).ends_with(";base64"))
        return decodeBase64(data);
    const std::string text = percentDecode(data);
    return std::vector<uint8_t>(text.begin(), text.end());
}

Result<std::string> decodeRelativeUri(std::string_view uri) {
    const size_t colon = uri.find(':');
    const size_t slash = uri.find_first_of("/\\");
    if (colon != std::string_view::npos && colon < slash)
        return invalidInput("uri \"{}\" has a scheme; only files beside the model and data URIs are read",
                            uri.substr(0, 80));
    std::string path = percentDecode(uri);
    if (path.empty() || path.front() == '/' || path.front() == '\\')
        return invalidInput("uri \"{}\" is not a path relative to the model", uri.substr(0, 80));
    if (path.find('\0') != std::string::npos)
        return invalidInput("a uri contains a zero byte");
    return path;
}

} // namespace glint::scene::gltf
