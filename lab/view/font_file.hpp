// Finds a scalable font for the panels among those that systems install.
#pragma once

#include <span>
#include <string>

namespace glint::view {

/// Where Debian, Ubuntu, Fedora, Arch, openSUSE and Windows keep their common sans-serif fonts; the preferred ones
/// first.
std::span<const char* const> fontPlaces();

/// Returns the first of the files that is a TrueType or OpenType font; empty: none is.
std::string findFont(std::span<const char* const> places);

} // namespace glint::view
