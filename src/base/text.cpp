#include "base/text.hpp"

#include <algorithm>
#include <limits>

namespace glint {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

bool equalIgnoringCase(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

// Levenshtein 1966: minimum number of insertions, deletions and substitutions; keeps one row of the table.
size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t substituted = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

bool isLikelyDistance(size_t distance, std::string_view text) {
    return distance <= std::max<size_t>(1, text.size() / 3);
}

std::string joinText(std::span<const std::string> parts, std::string_view separator) {
    std::string joined;
    for (const std::string& part : parts) {
        if (!joined.empty())
            joined += separator;
        joined += part;
    }
    return joined;
}

std::string listText(std::span<const std::string> parts, std::string_view last) {
    if (parts.size() < 2)
        return joinText(parts, "");
    return joinText(parts.first(parts.size() - 1), ", ").append(last) + parts.back();
}

std::string_view nearestText(std::string_view text, std::span<const std::string_view> candidates) {
    std::string_view nearest;
    size_t best = std::numeric_limits<size_t>::max();
    for (std::string_view candidate : candidates) {
        const size_t distance = editDistance(text, candidate);
        if (distance < best) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string_view likelyMeant(std::string_view text, std::span<const std::string_view> candidates) {
    if (text.size() > kLongestName || candidates.empty())
        return {};
    const std::string_view nearest = nearestText(text, candidates);
    return isLikelyDistance(editDistance(text, nearest), text) ? nearest : std::string_view();
}

std::string printable(std::string_view text, size_t longest) {
    const bool cut = text.size() > longest;
    std::string line(text.substr(0, longest));
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    }
    return cut ? line + "..." : line;
}

} // namespace glint
