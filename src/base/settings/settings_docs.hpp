// The tables of settings for readers: Markdown for docs/settings.md, JSON for programs, aligned text for a terminal.
#pragma once

#include "base/settings/settings_target.hpp"

namespace glint {

using SettingsTables = std::span<const std::span<const SettingInfo>>;

/// One table a group. Ends in a newline, as the others do.
std::string settingsMarkdown(SettingsTables tables);

/// One table of the settings that `glint tune` varies (SettingSearch).
std::string searchMarkdown(SettingsTables tables);

/// [{"key", "type", "default", "range": {"text", "min", "max", "minOpen", "maxOpen"}, "choices", "unit", "meaning",
///   "aliases": [{"name": "babylon:thickness", "transform": "1-x"}], "search": {"scale", "min", "max", "if": [...],
///   "motionOnly", "cost": "+"|"-"}}, ...]; what a setting lacks is left out.
std::string settingsTableJson(SettingsTables tables);

/// Key, default, range and meaning in columns.
std::string settingsText(SettingsTables tables);

} // namespace glint
