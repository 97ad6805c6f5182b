// SPDX-License-Identifier: MIT
// What is known about one setting. A list (settings_list.hpp; our renderer has another) states each setting once; from
// it come the structs, this table, JSON, --set, tooltips, the docs and the tuner's search space.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glint {

enum class SettingType { Boolean, Int, Float, Enum };

/// An interval; an open end does not belong to it. `text` is how the list writes it: "(0, 1e6]".
struct SettingRange {
    double min = 0;
    double max = 0;
    bool minOpen = false;
    bool maxOpen = false;
    std::string text; ///< empty for Boolean and Enum, which have no range
};

/// How the value of another system's parameter becomes the value of our setting.
enum class AliasTransform {
    Same,           ///< as it is
    OneMinus,       ///< 1-x: smoothness becomes roughness
    InverseOnePlus, ///< 1/(n+1): a downsampling becomes a scale
    Choice,         ///< a switch picks one of two enum values: `whenFalse`, `whenTrue`
    Fixed,          ///< whatever the value, the enum value `whenTrue`: the name implies a mode of ours
    Instead,        ///< the same, but only in place of `whenFalse`: other modes stay
    Numbers,        ///< `numbers` in place of the system's; else the value, of an enum by its name
    Component,      ///< of a colour, "R,G,B", a list in JSON, or one number for all three: `component`
};

/// A parameter of another system that this setting answers to, as `system:name`.
struct SettingAlias {
    std::string system; ///< "babylon", "hdrp", "compute-ssr": the name of its preset
    std::string name;
    AliasTransform transform = AliasTransform::Same;
    int whenFalse = 0;
    int whenTrue = 0;
    std::vector<std::pair<int, double>> numbers; ///< theirs, and our value: of an enum the index into `choices`
    int component = 0;                           ///< 0 red, 1 green, 2 blue
};

/// How a search varies a setting (`glint tune`).
struct SettingSearch {
    enum class Scale {
        Never,  ///< not varied
        Linear, ///< equal steps count alike
        Log,    ///< equal ratios count alike
        Choice, ///< any value of an enum
        Switch, ///< on and off
    };
    /// Another setting whose value this one needs to have an effect.
    struct Condition {
        std::string key;
        std::vector<std::string> values; ///< one of these, as text; empty: any number above `above`
        double above = 0;
    };
    Scale scale = Scale::Never;
    double min = 0; ///< Linear, Log: the interval worth searching, inside the range
    double max = 0;
    std::vector<Condition> conditions; ///< all of them, and those of the settings that they name
    bool motionOnly = false;           ///< matters only where something moves
    int cost = 0;                      ///< 1: larger values cost more; -1: less; 0: either
};

struct SettingInfo {
    std::string key; ///< "screen.maxDistance": group and name
    SettingType type = SettingType::Boolean;
    double defaultValue = 0; ///< Boolean: 0 or 1; Enum: index into `choices`
    SettingRange range;
    std::string unit;                 ///< "m", "px", "UV", "degrees", "EV"; empty: a plain number
    std::string meaning;              ///< one line
    std::vector<std::string> choices; ///< Enum: the values' names, in order
    std::vector<SettingAlias> aliases;
    SettingSearch search;
    size_t offset = 0; ///< bytes into the struct that the list makes
};

} // namespace glint

/// One row of a list as a member of its struct: `float maxDistance = 1000;`.
#define GLINT_SETTING_MEMBER(type, name, initial, range, unit, meaning, ...) type name = initial;

/// An enum that settings may have as their type. Its values' names in files begin in lower case: Linear is "linear". A
/// trailing underscore keeps a value apart from another library's macro (X11 defines None); files do not have it.
#define GLINT_SETTING_ENUM(Name, ...)                                                                                  \
    enum class Name : int { __VA_ARGS__ };                                                                             \
    constexpr std::string_view settingChoices(Name) {                                                                  \
        return #__VA_ARGS__;                                                                                           \
    }
