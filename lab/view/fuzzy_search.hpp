// Fuzzy search for names by a few letters: "rfmin" finds "Reflect Min".
#pragma once

#include <optional>
#include <string_view>

namespace glint::view {

/// Returns how well `text` matches `query`; larger is better. No value if `text` lacks a letter of the query in the
/// query's order; case and spaces of the query are ignored. Letters score higher if they follow each other, begin a
/// word, or begin the text; unmatched letters lower the score slightly. The empty query matches everything.
std::optional<int> fuzzyScore(std::string_view query, std::string_view text);

} // namespace glint::view
