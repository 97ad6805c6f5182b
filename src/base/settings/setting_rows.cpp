#include "base/settings/setting_rows.hpp"

#include "base/format.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace glint {
namespace {

[[noreturn]] void malformed(std::string_view key, std::string_view text) {
    std::fputs(formatText("glint: the list of settings is malformed at {}: '{}'\n", key, text).c_str(), stderr);
    std::abort();
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const size_t end = std::min(text.find(separator), text.size());
        if (end > 0)
            parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

/// "Linear, Hiz" becomes {"linear", "hiz"}.
std::vector<std::string> readChoices(std::string_view enumerators) {
    std::vector<std::string> choices;
    for (std::string_view part : split(enumerators, ',')) {
        std::string choice(part.substr(part.find_first_not_of(' ')));
        if (choice.ends_with('_')) // setting_info.hpp says why
            choice.pop_back();
        choice[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(choice[0])));
        choices.push_back(std::move(choice));
    }
    return choices;
}

double readNumber(std::string_view key, std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        malformed(key, text);
    return value;
}

/// "(0, 1e6]"
SettingRange readRange(std::string_view key, std::string_view text) {
    const size_t comma = text.find(',');
    if (text.size() < 5 || comma == text.npos || (text.front() != '[' && text.front() != '('))
        malformed(key, text);
    SettingRange range;
    range.min = readNumber(key, text.substr(1, comma - 1));
    range.max = readNumber(key, text.substr(comma + 1, text.size() - comma - 2));
    range.minOpen = text.front() == '(';
    range.maxOpen = text.back() == ')';
    range.text = text;
    return range;
}

int choiceIndex(const SettingInfo& info, std::string_view choice) {
    const auto found = std::ranges::find(info.choices, choice);
    if (found == info.choices.end())
        malformed(info.key, choice);
    return static_cast<int>(found - info.choices.begin());
}

/// "babylon:attenuateScreenBorders=none|smooth"
SettingAlias readAlias(const SettingInfo& info, std::string_view text) {
    const size_t colon = text.find(':');
    const size_t equals = std::min(text.find('='), text.size());
    if (colon == text.npos || colon == 0 || equals <= colon + 1)
        malformed(info.key, text);
    SettingAlias alias;
    alias.system = text.substr(0, colon);
    alias.name = text.substr(colon + 1, equals - colon - 1);
    if (equals == text.size())
        return alias;

    const std::string_view transform = text.substr(equals + 1);
    if (transform == "1-x") {
        alias.transform = AliasTransform::OneMinus;
    } else if (transform == "1/(n+1)") {
        alias.transform = AliasTransform::InverseOnePlus;
    } else if (info.type == SettingType::Float && (transform == "r" || transform == "g" || transform == "b")) {
        alias.transform = AliasTransform::Component;
        alias.component = static_cast<int>(std::string_view("rgb").find(transform));
    } else if (transform.find(':') != transform.npos) {
        alias.transform = AliasTransform::Numbers;
        for (const std::string_view part : split(transform, '|')) {
            const size_t mark = std::min(part.find(':'), part.size() - 1);
            const std::string_view ours = part.substr(mark + 1);
            alias.numbers.emplace_back(static_cast<int>(readNumber(info.key, part.substr(0, mark))),
                                       info.type == SettingType::Enum ? choiceIndex(info, ours)
                                                                      : readNumber(info.key, ours));
        }
    } else if (const size_t bar = transform.find('|'); bar != transform.npos) {
        alias.transform = AliasTransform::Choice;
        alias.whenFalse = choiceIndex(info, transform.substr(0, bar));
        alias.whenTrue = choiceIndex(info, transform.substr(bar + 1));
    } else if (const size_t arrow = transform.find('>'); arrow != transform.npos) {
        alias.transform = AliasTransform::Instead;
        alias.whenFalse = choiceIndex(info, transform.substr(0, arrow));
        alias.whenTrue = choiceIndex(info, transform.substr(arrow + 1));
    } else {
        alias.transform = AliasTransform::Fixed;
        alias.whenTrue = choiceIndex(info, transform);
    }
    return alias;
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// "screen.march=hiz|linear", "reuse.samples>0"
SettingSearch::Condition readCondition(const SettingInfo& info, std::string_view text) {
    const size_t mark = text.find_first_of("=>");
    if (mark == text.npos || mark == 0)
        malformed(info.key, text);
    SettingSearch::Condition condition;
    condition.key = text.substr(0, mark);
    const std::string_view value = text.substr(mark + 1);
    if (text[mark] == '>')
        condition.above = readNumber(info.key, value);
    else
        for (const std::string_view choice : split(value, '|'))
            condition.values.emplace_back(choice);
    if (text[mark] == '=' && condition.values.empty())
        malformed(info.key, text);
    return condition;
}

/// "0.1..1", inside the setting's range.
void readInterval(const SettingInfo& info, std::string_view text, SettingSearch& search) {
    const size_t dots = text.find("..");
    if (dots == text.npos)
        malformed(info.key, text);
    search.min = readNumber(info.key, text.substr(0, dots));
    search.max = readNumber(info.key, text.substr(dots + 2));
    const bool inside = search.min >= info.range.min && search.max <= info.range.max;
    if (!inside || search.min >= search.max || (search.scale == SettingSearch::Scale::Log && search.min <= 0))
        malformed(info.key, text);
}

/// "log 8..512; if screen.march=hiz; cost +"
SettingSearch readSearch(const SettingInfo& info, std::string_view text) {
    using Scale = SettingSearch::Scale;
    const bool number = info.type == SettingType::Int || info.type == SettingType::Float;
    SettingSearch search;
    for (const std::string_view whole : split(text, ';')) {
        const std::string_view part = trimmed(whole);
        const size_t space = std::min(part.find(' '), part.size());
        const std::string_view word = part.substr(0, space);
        const std::string_view rest = trimmed(part.substr(space));
        if ((word == "linear" || word == "log") && number) {
            search.scale = word == "log" ? Scale::Log : Scale::Linear;
            readInterval(info, rest, search);
        } else if (word == "choice" && info.type == SettingType::Enum && rest.empty()) {
            search.scale = Scale::Choice;
        } else if (word == "switch" && info.type == SettingType::Boolean && rest.empty()) {
            search.scale = Scale::Switch;
        } else if (word == "if") {
            search.conditions.push_back(readCondition(info, rest));
        } else if (word == "motion" && rest.empty()) {
            search.motionOnly = true;
        } else if (word == "cost" && (rest == "+" || rest == "-")) {
            search.cost = rest == "+" ? 1 : -1;
        } else {
            malformed(info.key, part);
        }
    }
    if (search.scale == Scale::Never)
        malformed(info.key, text);
    return search;
}

} // namespace

SettingInfo makeSettingInfo(std::string key, SettingType type, double defaultValue, size_t offset,
                            std::string_view choices, const SettingTexts& texts) {
    SettingInfo info;
    info.key = std::move(key);
    info.type = type;
    info.defaultValue = defaultValue;
    info.unit = texts.unit;
    info.meaning = texts.meaning;
    info.choices = readChoices(choices);
    info.offset = offset;
    if (type == SettingType::Int || type == SettingType::Float)
        info.range = readRange(info.key, texts.range);
    else if (!texts.range.empty())
        malformed(info.key, texts.range);
    for (std::string_view alias : split(texts.aliases, ' '))
        info.aliases.push_back(readAlias(info, alias));
    if (!texts.search.empty())
        info.search = readSearch(info, texts.search);
    return info;
}

} // namespace glint
