// From a list of settings (glint/settings_list.hpp) to its table: one SettingInfo a row.
#pragma once

#include "glint/setting_info.hpp"

#include <concepts>
#include <type_traits>

namespace glint {

/// The texts of one row, as the list writes them.
struct SettingTexts {
    std::string_view range, unit, meaning, aliases;
    std::string_view search = {}; ///< a row may leave it out
};

/// Parses the row's texts. A malformed row is a programmer's mistake: it ends the program with the key and the text.
SettingInfo makeSettingInfo(std::string key, SettingType type, double defaultValue, size_t offset,
                            std::string_view choices, const SettingTexts& texts);

template <class T>
SettingInfo makeSetting(std::string key, size_t offset, T defaultValue, const SettingTexts& texts) {
    if constexpr (std::is_enum_v<T>) {
        return makeSettingInfo(std::move(key), SettingType::Enum, static_cast<int>(defaultValue), offset,
                               settingChoices(defaultValue), texts);
    } else {
        static_assert(std::same_as<T, bool> || std::same_as<T, int> || std::same_as<T, float>);
        constexpr SettingType type = std::same_as<T, bool>  ? SettingType::Boolean
                                     : std::same_as<T, int> ? SettingType::Int
                                                            : SettingType::Float;
        return makeSettingInfo(std::move(key), type, static_cast<double>(defaultValue), offset, {}, texts);
    }
}

} // namespace glint

/// One row of a list; used inside GLINT_SETTING_GROUP only.
#define GLINT_SETTING_ROW(type, name, initial, range, unit, meaning, ...)                                              \
    rows.push_back(::glint::makeSetting<type>(groupKey + "." #name, groupOffset + offsetof(Group, name), initial,      \
                                              {range, unit, meaning, __VA_ARGS__}));

/// Appends the rows of one group to `rows`: `GLINT_SETTING_GROUP(rows, Settings, screen, GLINT_SCREEN_SETTINGS)`.
#define GLINT_SETTING_GROUP(rows, Whole, group, LIST)                                                                  \
    {                                                                                                                  \
        using Group = decltype(Whole::group);                                                                          \
        const std::string groupKey = #group;                                                                           \
        const size_t groupOffset = offsetof(Whole, group);                                                             \
        LIST(GLINT_SETTING_ROW)                                                                                        \
    }
