#include "base/settings/settings_docs.hpp"

#include "base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint {
namespace {

using Json = nlohmann::ordered_json;

std::string_view typeName(SettingType type) {
    switch (type) {
    case SettingType::Boolean: return "bool";
    case SettingType::Int: return "int";
    case SettingType::Float: return "float";
    case SettingType::Enum: break;
    }
    return "enum";
}

/// "0: rgba8, 2: rgba16f"
std::string numbersText(const SettingInfo& info, const SettingAlias& alias) {
    std::vector<std::string> pairs;
    for (const auto& [theirs, ours] : alias.numbers)
        pairs.push_back(formatText("{}: {}", theirs, settingText(info, ours)));
    return joinText(pairs, ", ");
}

/// As the list writes it behind the '=': empty where the alias means the same.
std::string transformText(const SettingInfo& info, const SettingAlias& alias) {
    switch (alias.transform) {
    case AliasTransform::Same: break;
    case AliasTransform::OneMinus: return "1-x";
    case AliasTransform::InverseOnePlus: return "1/(n+1)";
    case AliasTransform::Choice:
        return formatText("{}|{}", settingText(info, alias.whenFalse), settingText(info, alias.whenTrue));
    case AliasTransform::Fixed:
    case AliasTransform::Instead: return settingText(info, alias.whenTrue);
    case AliasTransform::Numbers: return numbersText(info, alias);
    case AliasTransform::Component: return std::string(1, "rgb"[alias.component]);
    }
    return {};
}

/// "`babylon:attenuateScreenBorders` (false: none, true: smooth)"
std::string aliasMarkdown(const SettingInfo& info, const SettingAlias& alias) {
    std::string name = formatText("`{}:{}`", alias.system, alias.name);
    switch (alias.transform) {
    case AliasTransform::Same: break;
    case AliasTransform::Choice:
        return formatText("{} (false: {}, true: {})", name, settingText(info, alias.whenFalse),
                          settingText(info, alias.whenTrue));
    case AliasTransform::Fixed: return formatText("{} (implies {})", name, settingText(info, alias.whenTrue));
    case AliasTransform::Instead:
        return formatText("{} (makes {} {})", name, settingText(info, alias.whenFalse),
                          settingText(info, alias.whenTrue));
    case AliasTransform::OneMinus:
    case AliasTransform::Numbers:
    case AliasTransform::Component:
    case AliasTransform::InverseOnePlus: return formatText("{} ({})", name, transformText(info, alias));
    }
    return name;
}

/// "(0, 1e6] m", "true, false", "linear"
std::string allowed(const SettingInfo& info) {
    if (info.type == SettingType::Boolean)
        return "true, false";
    if (info.type == SettingType::Enum)
        return joinText(info.choices, ", ");
    return info.unit.empty() ? info.range.text : info.range.text + " " + info.unit;
}

std::string defaultText(const SettingInfo& info) {
    return settingText(info, info.defaultValue);
}

std::string_view groupOf(const SettingInfo& info) {
    return std::string_view(info.key).substr(0, info.key.rfind('.'));
}

std::string_view scaleName(SettingSearch::Scale scale) {
    switch (scale) {
    case SettingSearch::Scale::Linear: return "linear";
    case SettingSearch::Scale::Log: return "log";
    case SettingSearch::Scale::Choice: return "choice";
    case SettingSearch::Scale::Switch: return "switch";
    case SettingSearch::Scale::Never: break;
    }
    return "none";
}

/// "screen.march = hiz or linear", "reuse.samples > 0"
std::string conditionText(const SettingSearch::Condition& condition) {
    if (condition.values.empty())
        return formatText("{} > {:g}", condition.key, condition.above);
    return formatText("{} = {}", condition.key, listText(condition.values, " or "));
}

std::vector<std::string> conditionTexts(const SettingSearch& search) {
    std::vector<std::string> texts;
    for (const SettingSearch::Condition& condition : search.conditions)
        texts.push_back(conditionText(condition));
    return texts;
}

bool hasInterval(const SettingSearch& search) {
    return search.scale == SettingSearch::Scale::Linear || search.scale == SettingSearch::Scale::Log;
}

Json searchJson(const SettingSearch& search) {
    Json json = {{"scale", scaleName(search.scale)}};
    if (hasInterval(search)) {
        json["min"] = search.min;
        json["max"] = search.max;
    }
    if (!search.conditions.empty())
        json["if"] = conditionTexts(search);
    if (search.motionOnly)
        json["motionOnly"] = true;
    if (search.cost != 0)
        json["cost"] = search.cost > 0 ? "+" : "-";
    return json;
}

Json infoJson(const SettingInfo& info) {
    const std::string value = defaultText(info);
    Json json = {{"key", info.key}, {"type", typeName(info.type)}};
    json["default"] = info.type == SettingType::Enum ? Json(value) : Json::parse(value);
    if (!info.range.text.empty()) {
        json["range"] = {{"text", info.range.text},
                         {"min", info.range.min},
                         {"max", info.range.max},
                         {"minOpen", info.range.minOpen},
                         {"maxOpen", info.range.maxOpen}};
    }
    if (!info.choices.empty())
        json["choices"] = info.choices;
    if (!info.unit.empty())
        json["unit"] = info.unit;
    json["meaning"] = info.meaning;
    for (const SettingAlias& alias : info.aliases) {
        Json entry = {{"name", alias.system + ":" + alias.name}};
        if (alias.transform != AliasTransform::Same)
            entry["transform"] = transformText(info, alias);
        json["aliases"].push_back(std::move(entry));
    }
    if (info.search.scale != SettingSearch::Scale::Never)
        json["search"] = searchJson(info.search);
    return json;
}

} // namespace

std::string settingsMarkdown(SettingsTables tables) {
    std::string text;
    std::string_view group;
    for (const auto& table : tables) {
        for (const SettingInfo& info : table) {
            if (groupOf(info) != group) {
                group = groupOf(info);
                text += formatText("{}## {}\n\n| Key | Default | Range | Meaning | In other systems |\n"
                                   "|---|---|---|---|---|\n",
                                   text.empty() ? "" : "\n", group);
            }
            std::vector<std::string> aliases;
            for (const SettingAlias& alias : info.aliases)
                aliases.push_back(aliasMarkdown(info, alias));
            text += formatText("| `{}` | {} | {} | {} | {} |\n", info.key, defaultText(info), allowed(info),
                               info.meaning, joinText(aliases, ", "));
        }
    }
    return text;
}

std::string searchMarkdown(SettingsTables tables) {
    std::string text = "| Key | Varied | Has an effect only if | Larger values cost |\n|---|---|---|---|\n";
    for (const auto& table : tables) {
        for (const SettingInfo& info : table) {
            const SettingSearch& search = info.search;
            if (search.scale == SettingSearch::Scale::Never)
                continue;
            std::vector<std::string> conditions = conditionTexts(search);
            if (search.motionOnly)
                conditions.emplace_back("something moves");
            text += formatText("| `{}` | {}{} | {} | {} |\n", info.key, scaleName(search.scale),
                               hasInterval(search) ? formatText(" {:g} to {:g}", search.min, search.max) : "",
                               joinText(conditions, ", "),
                               search.cost > 0   ? "more"
                               : search.cost < 0 ? "less"
                                                 : "");
        }
    }
    return text;
}

std::string settingsTableJson(SettingsTables tables) {
    Json all = Json::array();
    for (const auto& table : tables) {
        for (const SettingInfo& info : table)
            all.push_back(infoJson(info));
    }
    return all.dump(2) + "\n";
}

std::string settingsText(SettingsTables tables) {
    size_t keyWidth = 0, defaultWidth = 0, rangeWidth = 0;
    for (const auto& table : tables) {
        for (const SettingInfo& info : table) {
            keyWidth = std::max(keyWidth, info.key.size());
            defaultWidth = std::max(defaultWidth, defaultText(info).size());
            rangeWidth = std::max(rangeWidth, allowed(info).size());
        }
    }
    std::string text;
    for (const auto& table : tables) {
        for (const SettingInfo& info : table)
            text += formatText("{:<{}}  {:<{}}  {:<{}}  {}\n", info.key, keyWidth, defaultText(info), defaultWidth,
                               allowed(info), rangeWidth, info.meaning);
    }
    return text;
}

} // namespace glint
