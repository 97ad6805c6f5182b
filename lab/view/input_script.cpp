#include "lab/view/input_script.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace glint::view {
namespace {

using Kind = ScriptStep::Kind;

enum class Rest { Nothing, Numbers, Stroke, Text, NumbersThenButton };

struct Word {
    std::string_view word;
    Kind kind;
    Rest rest;
    size_t count; ///< of numbers
    std::string_view usage;
};

constexpr std::array kWords = {
    Word{"frame", Kind::Frame, Rest::Numbers, 1, "frame N"},
    Word{"still", Kind::Still, Rest::Nothing, 0, "still"},
    Word{"quiet", Kind::Quiet, Rest::Nothing, 0, "quiet"},
    Word{"key", Kind::Key, Rest::Stroke, 0, "key NAME"},
    Word{"press", Kind::Press, Rest::Stroke, 0, "press NAME"},
    Word{"release", Kind::Release, Rest::Stroke, 0, "release NAME"},
    Word{"type", Kind::Type, Rest::Text, 0, "type TEXT"},
    Word{"move", Kind::Move, Rest::Numbers, 2, "move X Y"},
    Word{"click", Kind::Click, Rest::Numbers, 2, "click X Y"},
    Word{"doubleclick", Kind::DoubleClick, Rest::Numbers, 2, "doubleclick X Y"},
    Word{"drag", Kind::Drag, Rest::NumbersThenButton, 4, "drag X Y X2 Y2 [right|middle]"},
    Word{"scroll", Kind::Scroll, Rest::Numbers, 1, "scroll N"},
    Word{"resize", Kind::Resize, Rest::Numbers, 2, "resize W H"},
    Word{"minimize", Kind::Minimize, Rest::Nothing, 0, "minimize"},
    Word{"restore", Kind::Restore, Rest::Nothing, 0, "restore"},
    Word{"drop", Kind::Drop, Rest::Text, 0, "drop FILE"},
    Word{"screenshot", Kind::Screenshot, Rest::Text, 0, "screenshot FILE.png"},
    Word{"picture", Kind::Picture, Rest::Text, 0, "picture FILE"},
    Word{"stats", Kind::Stats, Rest::Text, 0, "stats FILE.json"},
    Word{"save", Kind::Save, Rest::Text, 0, "save FILE.json"},
    Word{"close", Kind::Close, Rest::Nothing, 0, "close"},
};

/// Removes and returns the first word of `text`.
std::string_view takeWord(std::string_view& text) {
    const size_t start = std::min(text.find_first_not_of(" \t"), text.size());
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find_first_of(" \t"));
    text.remove_prefix(word.size());
    return word;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text;
}

std::optional<int> takeNumber(std::string_view& text) {
    const std::string_view word = takeWord(text);
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return number;
}

Result<ScriptStep> readStep(std::string_view line) {
    std::string_view rest = line;
    const std::string_view first = takeWord(rest);
    const auto word = std::ranges::find(kWords, first, &Word::word);
    if (word == kWords.end()) {
        std::vector<std::string> names;
        for (const Word& known : kWords)
            names.emplace_back(known.word);
        return invalidInput("unknown word '{}'; there are {}", printable(first), listText(names, " and "));
    }
    ScriptStep step;
    step.kind = word->kind;
    const auto expected = [&] { return invalidInput("expected `{}`, got `{}`", word->usage, printable(line)); };
    if (word->rest == Rest::Stroke) {
        GLINT_TRY(stroke, readKeyStroke(trimmed(rest)));
        step.stroke = stroke;
        return step;
    }
    for (size_t i = 0; i < word->count; ++i) {
        const std::optional<int> number = takeNumber(rest);
        if (!number)
            return expected();
        step.numbers.push_back(*number);
    }
    step.text = trimmed(rest);
    const bool button = step.text.empty() || step.text == "right" || step.text == "middle";
    if (word->rest == Rest::Text                ? step.text.empty()
        : word->rest == Rest::NumbersThenButton ? !button
                                                : !step.text.empty())
        return expected();
    const bool sizes = step.kind == Kind::Frame || step.kind == Kind::Resize;
    if (sizes && std::ranges::any_of(step.numbers, [](int number) { return number < 1 || number > 16384; }))
        return expected();
    return step;
}

} // namespace

Result<std::vector<ScriptStep>> readScript(std::string_view text, std::string_view name) {
    std::vector<ScriptStep> steps;
    int number = 0;
    while (!text.empty()) {
        ++number;
        const size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#')
            continue;
        auto step = readStep(line);
        if (!step)
            return invalidInput("{}:{}: {}", printable(name), number, step.error().message);
        step->line = number;
        steps.push_back(*std::move(step));
    }
    return steps;
}

} // namespace glint::view
