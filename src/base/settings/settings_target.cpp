#include "base/settings/settings_target.hpp"

#include "base/format.hpp"
#include "base/settings/setting_suggestion.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>

namespace glint {
namespace {

using Kind = SettingInput::Kind;

/// A setting that a name leads to; no alias: by its own key.
struct Match {
    const SettingInfo* info = nullptr;
    const SettingAlias* alias = nullptr;
    void* object = nullptr;
};

std::vector<Match> matchKey(SettingsTargets targets, std::string_view name) {
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            if (info.key == name)
                return {{&info, nullptr, target.object}};
        }
    }
    return {};
}

std::string fullName(const SettingAlias& alias) {
    return alias.system + ":" + alias.name;
}

template <class Wanted>
std::vector<Match> matchAliases(SettingsTargets targets, Wanted wanted) {
    std::vector<Match> matches;
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            for (const SettingAlias& alias : info.aliases) {
                if (wanted(alias))
                    matches.push_back({&info, &alias, target.object});
            }
        }
    }
    return matches;
}

Error unknownName(SettingsTargets targets, std::string_view name) {
    if (name == "environmentTexture" || name == "babylon:environmentTexture" || name == "environment.texture")
        return invalidArgument("{}: a picture is no setting; --env FILE says which, and sky.enabled whether rays that "
                               "miss show it",
                               name);
    std::vector<std::string> meant = likelySettings(targets, name);
    for (std::string& suggestion : meant)
        suggestion = formatText("'{}'", suggestion);
    if (!meant.empty())
        return invalidArgument("unknown setting '{}'; did you mean {}?", printable(name), listText(meant, " or "));
    return invalidArgument("unknown setting '{}'; `glint settings` lists them all", printable(name));
}

Result<std::vector<Match>> findSettings(SettingsTargets targets, std::string_view name, std::string_view system) {
    if (auto matches = matchKey(targets, name); !matches.empty())
        return matches;
    if (auto matches = matchAliases(targets, [&](const SettingAlias& a) { return fullName(a) == name; });
        !matches.empty())
        return matches;

    auto matches = matchAliases(targets, [&](const SettingAlias& a) { return a.name == name; });
    if (matches.empty())
        return unknownName(targets, name);
    std::set<std::string> systems;
    for (const Match& match : matches)
        systems.insert(match.alias->system);
    if (systems.size() == 1)
        return matches;
    if (systems.contains(std::string(system))) {
        std::erase_if(matches, [&](const Match& match) { return match.alias->system != system; });
        return matches;
    }
    std::vector<std::string> candidates;
    for (const std::string& candidate : systems)
        candidates.push_back(formatText("'{}:{}'", candidate, name));
    return invalidArgument("'{}' is a name in several systems: write {}", printable(name),
                           listText(candidates, " or "));
}

// ---------------------------------------------------------------- values

/// The type in which a value is written under this name, which an alias may change.
SettingType writtenType(const Match& match) {
    switch (match.alias ? match.alias->transform : AliasTransform::Same) {
    case AliasTransform::OneMinus: return SettingType::Float;
    case AliasTransform::InverseOnePlus: return SettingType::Int;
    case AliasTransform::Choice: return SettingType::Boolean;
    case AliasTransform::Same:
    case AliasTransform::Fixed:
    case AliasTransform::Instead:
    case AliasTransform::Component:
    case AliasTransform::Numbers: break;
    }
    return match.info->type;
}

Error wrongType(std::string_view name, std::string_view expected, const SettingInput& input) {
    const std::string_view open = input.kind == Kind::String ? "\"" : input.kind == Kind::List ? "[" : "'";
    return invalidArgument("{}: expected {}, got {}{}{}", printable(name), expected, open, printable(input.text),
                           input.kind == Kind::List ? "]" : open);
}

bool kindIs(const SettingInput& input, Kind kind) {
    return input.kind == Kind::Any || input.kind == kind;
}

Result<double> readBool(std::string_view name, const SettingInput& input) {
    const bool isTrue = input.text == "true";
    if (!kindIs(input, Kind::Bool) || (!isTrue && input.text != "false"))
        return wrongType(name, "true or false", input);
    return isTrue ? 1.0 : 0.0;
}

/// "0x0F", as masks are written on a command line; JSON has no such numbers.
std::optional<double> readHexadecimal(const SettingInput& input) {
    if (input.kind != Kind::Any || (!input.text.starts_with("0x") && !input.text.starts_with("0X")))
        return std::nullopt;
    const std::string_view digits = input.text.substr(2);
    uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (error != std::errc() || end != digits.data() + digits.size())
        return std::nullopt;
    return static_cast<double>(value);
}

Result<double> readNumber(std::string_view name, const SettingInput& input, bool whole) {
    const std::string_view expected = whole ? "a whole number" : "a number";
    if (const auto hexadecimal = readHexadecimal(input); whole && hexadecimal)
        return *hexadecimal;
    double value = 0;
    const char* const textEnd = input.text.data() + input.text.size();
    const auto [end, error] = std::from_chars(input.text.data(), textEnd, value);
    if (!kindIs(input, Kind::Number) || error != std::errc() || end != textEnd)
        return wrongType(name, expected, input);
    if (whole && std::isfinite(value) && value != std::floor(value))
        return wrongType(name, expected, input);
    return value;
}

/// By name, in any case: other systems write "HiZ" and "Proxy".
auto findChoice(const std::vector<std::string>& choices, std::string_view text) {
    return std::ranges::find_if(choices, [&](const std::string& choice) { return equalIgnoringCase(choice, text); });
}

Result<double> readChoice(std::string_view name, const SettingInfo& info, const SettingInput& input) {
    const auto found = findChoice(info.choices, input.text);
    if (kindIs(input, Kind::String) && found != info.choices.end())
        return static_cast<double>(found - info.choices.begin());
    return wrongType(name, listText(info.choices, " or "), input);
}

/// One of the other system's numbers, or the name of our own value.
Result<double> readNumberOrChoice(std::string_view name, const Match& match, const SettingInput& input) {
    std::vector<std::string> known;
    for (const auto& [theirs, ours] : match.alias->numbers) {
        known.push_back(std::to_string(theirs));
        if (kindIs(input, Kind::Number) && input.text == known.back())
            return ours;
    }
    const std::vector<std::string>& choices = match.info->choices;
    if (kindIs(input, Kind::String) && findChoice(choices, input.text) != choices.end())
        return readChoice(name, *match.info, input);
    known.insert(known.end(), choices.begin(), choices.end());
    return wrongType(name, listText(known, " or "), input);
}

/// "0.9,0.5,0.2", "0.9 0.5 0.2", a list of three numbers, or one number for all three.
Result<double> readComponent(std::string_view name, const SettingAlias& alias, const SettingInput& input) {
    constexpr std::string_view kExpected = "a colour as R,G,B or one number";
    constexpr std::string_view kBetween = ", ";
    std::vector<double> values;
    for (std::string_view rest = input.text; !rest.empty();) {
        const std::string_view part = rest.substr(0, rest.find_first_of(kBetween));
        const auto value = readNumber(name, {part, Kind::Any}, false);
        if (!value)
            return wrongType(name, kExpected, input);
        values.push_back(*value);
        rest.remove_prefix(part.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
    }
    const bool isList = input.kind == Kind::List;
    const bool fits = values.size() == 3 ? isList || kindIs(input, Kind::String) : values.size() == 1 && !isList;
    if (!fits || input.kind == Kind::Bool)
        return wrongType(name, kExpected, input);
    return values.size() == 3 ? values[static_cast<size_t>(alias.component)] : values[0];
}

Result<double> readValue(std::string_view name, const Match& match, const SettingInput& input) {
    if (match.alias && match.alias->transform == AliasTransform::Component)
        return readComponent(name, *match.alias, input);
    switch (writtenType(match)) {
    case SettingType::Boolean: return readBool(name, input);
    case SettingType::Int: return readNumber(name, input, true);
    case SettingType::Float: return readNumber(name, input, false);
    case SettingType::Enum: break;
    }
    if (match.alias && !match.alias->numbers.empty())
        return readNumberOrChoice(name, match, input);
    return readChoice(name, *match.info, input);
}

double transformed(const SettingInfo& info, const SettingAlias* alias, double value) {
    if (alias && info.type != SettingType::Enum)
        for (const auto& [theirs, ours] : alias->numbers)
            if (value == theirs)
                return ours;
    switch (alias ? alias->transform : AliasTransform::Same) {
    case AliasTransform::OneMinus: return 1 - value;
    case AliasTransform::InverseOnePlus: return 1 / (value + 1);
    case AliasTransform::Choice: return value != 0 ? alias->whenTrue : alias->whenFalse;
    case AliasTransform::Fixed:
    case AliasTransform::Instead: return alias->whenTrue;
    case AliasTransform::Same:
    case AliasTransform::Component:
    case AliasTransform::Numbers: break;
    }
    return value;
}

/// A double as the setting will hold it: a tiny positive number may become 0 in a float and leave an open range.
double narrowed(const SettingInfo& info, double value) {
    return info.type == SettingType::Float ? static_cast<double>(static_cast<float>(value)) : value;
}

/// `held`: the value as the setting holds it. So are the ends: 0.2f is above 0.2, and still the end of [0, 0.2].
bool inRange(const SettingInfo& info, double held) {
    const SettingRange& range = info.range;
    const double min = narrowed(info, range.min);
    const double max = narrowed(info, range.max);
    return range.text.empty() ||
           ((range.minOpen ? held > min : held >= min) && (range.maxOpen ? held < max : held <= max));
}

Error outOfRange(const SettingInfo& info, std::string_view value) {
    const std::string_view space = info.unit.empty() ? "" : " ";
    return invalidArgument("{} = {} is out of range {}{}{}", info.key, value, info.range.text, space, info.unit);
}

Result<SettingAssignment> makeAssignment(std::string_view name, const Match& match, const SettingInput& input) {
    const SettingInfo& info = *match.info;
    SettingAssignment assignment{&info, match.object, 0, false};
    const AliasTransform transform = match.alias ? match.alias->transform : AliasTransform::Same;
    if (transform == AliasTransform::Fixed || transform == AliasTransform::Instead) {
        assignment.value = match.alias->whenTrue;
        assignment.implied = true;
        if (transform == AliasTransform::Instead)
            assignment.insteadOf = match.alias->whenFalse;
        return assignment;
    }
    GLINT_TRY(written, readValue(name, match, input));
    const double value = transformed(info, match.alias, written);
    assignment.value = narrowed(info, value);
    if (!inRange(info, assignment.value)) {
        Error error = outOfRange(info, formatText("{}", value));
        if (match.alias)
            error.message += formatText(" (from {} = {})", fullName(*match.alias), printable(input.text));
        return error;
    }
    return assignment;
}

} // namespace

double settingValue(const SettingInfo& info, const void* object) {
    const std::byte* const at = static_cast<const std::byte*>(object) + info.offset;
    if (info.type == SettingType::Boolean)
        return *reinterpret_cast<const bool*>(at) ? 1 : 0;
    if (info.type == SettingType::Float)
        return static_cast<double>(*reinterpret_cast<const float*>(at));
    int value = 0; // int or an enum over int, which memcpy may read as int
    std::memcpy(&value, at, sizeof value);
    return value;
}

std::string settingText(const SettingInfo& info, double value) {
    switch (info.type) {
    case SettingType::Boolean: return value != 0 ? "true" : "false";
    case SettingType::Int: return formatText("{}", static_cast<int>(value));
    case SettingType::Float: return formatText("{}", static_cast<float>(value));
    case SettingType::Enum: break;
    }
    const auto index = static_cast<size_t>(value);
    return value >= 0 && index < info.choices.size() ? info.choices[index] : formatText("{}", value);
}

Result<std::vector<SettingAssignment>> resolveSetting(SettingsTargets targets, std::string_view name,
                                                      const SettingInput& input, std::string_view system) {
    GLINT_TRY(matches, findSettings(targets, name, system));
    std::vector<SettingAssignment> assignments;
    for (const Match& match : matches) {
        GLINT_TRY(assignment, makeAssignment(name, match, input));
        assignments.push_back(assignment);
    }
    return assignments;
}

void assignSettings(std::span<const SettingAssignment> assignments) {
    for (const SettingAssignment& assignment : assignments) {
        std::byte* const at = static_cast<std::byte*>(assignment.object) + assignment.info->offset;
        if (assignment.insteadOf && settingValue(*assignment.info, assignment.object) != *assignment.insteadOf)
            continue;
        if (assignment.info->type == SettingType::Boolean) {
            *reinterpret_cast<bool*>(at) = assignment.value != 0;
        } else if (assignment.info->type == SettingType::Float) {
            *reinterpret_cast<float*>(at) = static_cast<float>(assignment.value);
        } else {
            const int value = static_cast<int>(assignment.value);
            std::memcpy(at, &value, sizeof value);
        }
    }
}

Result<void> setSetting(SettingsTargets targets, std::string_view name, std::string_view value,
                        std::string_view system) {
    GLINT_TRY(assignments, resolveSetting(targets, name, {value, Kind::Any}, system));
    assignSettings(assignments);
    return {};
}

Result<void> validateSettings(SettingsTargets targets) {
    for (const SettingsTarget& target : targets) {
        for (const SettingInfo& info : target.table) {
            const double value = settingValue(info, target.object);
            if (info.type == SettingType::Enum && (value < 0 || value >= static_cast<double>(info.choices.size())))
                return invalidArgument("{} = {} is none of {}", info.key, value, joinText(info.choices, ", "));
            if (!inRange(info, value))
                return outOfRange(info, settingText(info, value));
        }
    }
    return {};
}

} // namespace glint
