// Settings as JSON, read with line-numbered errors.
#pragma once

#include "base/settings/settings_target.hpp"

namespace glint {

/// Sets what `text` names, nested or flat, keys or aliases; a top-level "description" is for people. All or nothing.
/// Errors: InvalidInput, "name:line: ..." for JSON that does not parse, unknown names, wrong types, values out of
/// range, a setting set twice.
Result<void> readSettingsJson(SettingsTargets targets, std::string_view text, std::string_view name,
                              std::string_view system);

/// Every setting, nested by group, in the tables' order; ends in a newline.
std::string writeSettingsJson(SettingsTargets targets);

} // namespace glint
