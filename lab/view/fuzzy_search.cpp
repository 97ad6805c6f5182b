#include "lab/view/fuzzy_search.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace glint::view {
namespace {

constexpr int kLetter = 1;
constexpr int kFollows = 10;    ///< directly after the previous match
constexpr int kBeginsWord = 8;  ///< also in camelCase
constexpr int kBeginsText = 12; ///< instead of kBeginsWord
constexpr int kNone = -1000000;

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool isLetter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

int worthAt(std::string_view text, size_t i) {
    if (i == 0)
        return kLetter + kBeginsText;
    const bool camel = std::isupper(static_cast<unsigned char>(text[i])) != 0 &&
                       std::islower(static_cast<unsigned char>(text[i - 1])) != 0;
    return kLetter + (!isLetter(text[i - 1]) || camel ? kBeginsWord : 0);
}

} // namespace

std::optional<int> fuzzyScore(std::string_view query, std::string_view text) {
    std::vector<char> letters;
    for (const char c : query)
        if (c != ' ')
            letters.push_back(lower(c));
    if (letters.empty())
        return 0;
    // best[i]: the best score of the letters so far with the last of them at text[i].
    std::vector<int> best(text.size(), kNone);
    for (size_t n = 0; n < letters.size(); ++n) {
        std::vector<int> next(text.size(), kNone);
        int before = n == 0 ? 0 : kNone; // the best score that ends anywhere before i - 1
        for (size_t i = 0; i < text.size(); ++i) {
            if (lower(text[i]) == letters[n]) {
                const int follows = n > 0 && i > 0 && best[i - 1] > kNone ? best[i - 1] + kFollows : kNone;
                const int from = std::max(before, follows);
                if (from > kNone)
                    next[i] = from + worthAt(text, i);
            }
            if (n > 0 && i > 0)
                before = std::max(before, best[i - 1]);
        }
        best = std::move(next);
    }
    const auto found = std::ranges::max_element(best);
    if (found == best.end() || *found == kNone)
        return std::nullopt;
    return *found - static_cast<int>(text.size()) / 8;
}

} // namespace glint::view
