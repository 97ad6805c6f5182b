// Small helpers on text for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// Longer texts are not misspelt names, and comparing them would cost quadratic time.
constexpr size_t kLongestName = 100;

std::string joinText(std::span<const std::string> parts, std::string_view separator);

/// "a, b or c" with `last` = " or ".
std::string listText(std::span<const std::string> parts, std::string_view last);

/// True if the texts differ at most in the case of the letters A to Z.
bool equalIgnoringCase(std::string_view a, std::string_view b);

/// The least number of characters to insert, delete or replace that turns `a` into `b`, letters' case ignored.
size_t editDistance(std::string_view a, std::string_view b);

/// True if at most a third of `text` has to change, for "did you mean ...?"; a single character always may.
bool isLikelyDistance(size_t distance, std::string_view text);

/// The candidate with the smallest edit distance to `text` (letters' case ignored); empty if there are none.
std::string_view nearestText(std::string_view text, std::span<const std::string_view> candidates);

/// For "did you mean ...?": the nearest candidate, or empty where it is not near enough (isLikelyDistance).
std::string_view likelyMeant(std::string_view text, std::span<const std::string_view> candidates);

/// Text from outside on its way into a message: one line of at most `longest` characters. Control characters become
/// '?', a cut ends in "...".
std::string printable(std::string_view text, size_t longest = 80);

} // namespace glint
