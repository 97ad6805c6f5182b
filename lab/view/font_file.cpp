#include "lab/view/font_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace glint::view {
namespace {

/// ImGui asserts that a font's file can be read and is a font, so both are checked here.
bool isFont(const char* path) {
    using namespace std::string_view_literals;
    constexpr std::array kKinds = {"\0\1\0\0"sv, "true"sv, "OTTO"sv, "ttcf"sv}; // OpenType 1.9, "Table Directory"
    std::array<char, 4> tag = {};
    const bool whole = std::ifstream(path, std::ios::binary).read(tag.data(), tag.size()).good();
    return whole && std::ranges::find(kKinds, std::string_view(tag.data(), tag.size())) != kKinds.end();
}

} // namespace

std::span<const char* const> fontPlaces() {
    static constexpr std::array kPlaces = {
        "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",                   // Debian, Ubuntu: fonts-dejavu-core
        "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",                 // Fedora
        "/usr/share/fonts/TTF/DejaVuSans.ttf",                               // Arch
        "/usr/share/fonts/truetype/DejaVuSans.ttf",                          // openSUSE
        "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",               // Debian, Ubuntu: fonts-noto-core
        "/usr/share/fonts/google-noto/NotoSans-Regular.ttf",                 // Fedora
        "/usr/share/fonts/google-noto-vf/NotoSans[wght].ttf",                // Fedora, its default
        "/usr/share/fonts/noto/NotoSans-Regular.ttf",                        // Arch
        "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",   // Debian, Ubuntu: fonts-liberation
        "/usr/share/fonts/liberation-sans-fonts/LiberationSans-Regular.ttf", // Fedora
        "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",       // Fedora, earlier
        "/usr/share/fonts/liberation/LiberationSans-Regular.ttf",            // Arch
        "/usr/share/fonts/truetype/ubuntu/Ubuntu-R.ttf",                     // Ubuntu's desktop
        "C:/Windows/Fonts/segoeui.ttf",
        "C:/Windows/Fonts/arial.ttf",
    };
    return kPlaces;
}

std::string findFont(std::span<const char* const> places) {
    const auto found = std::ranges::find_if(places, isFont);
    return found == places.end() ? std::string() : *found;
}

} // namespace glint::view
