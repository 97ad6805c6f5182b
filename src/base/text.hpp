// Small helpers on text for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

std::string joinText(std::span<const std::string> parts, std::string_view separator);

/// "a, b or c" with `last` = " or ".
std::string listText(std::span<const std::string> parts, std::string_view last);

/// The candidate with the smallest edit distance to `text` (letters' case ignored); empty if there are none.
std::string_view nearestText(std::string_view text, std::span<const std::string_view> candidates);

/// For "did you mean ...?": the nearest candidate, or empty where more than a third of `text` would have to change.
std::string_view likelyMeant(std::string_view text, std::span<const std::string_view> candidates);

/// Text from outside on its way into a message: one line of at most `longest` characters. Control characters become
/// '?', a cut ends in "...".
std::string printable(std::string_view text, size_t longest = 80);

} // namespace glint
