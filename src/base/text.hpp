// Small helpers on text for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

std::string joinText(std::span<const std::string> parts, std::string_view separator);

/// The candidate with the smallest edit distance to `text` (letters' case ignored); empty if there are none.
std::string_view nearestText(std::string_view text, std::span<const std::string_view> candidates);

} // namespace glint
