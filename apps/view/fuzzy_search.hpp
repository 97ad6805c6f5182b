// Finds what a person means by a few letters: "rfmin" finds "Reflect Min".
#pragma once

#include <optional>
#include <string_view>

namespace glint::view {

/// How well `text` answers to `query`; larger is better. No answer where a letter of the query is missing in `text`, in
/// the query's order; case and spaces of the query do not count. Letters that follow each other, that begin a word, or
/// that begin the text count more; what is left over counts a little against it. The empty query finds everything.
std::optional<int> fuzzyScore(std::string_view query, std::string_view text);

} // namespace glint::view
