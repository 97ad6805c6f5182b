// Which settings a name may mean that no setting has: "did you mean ...?".
#pragma once

#include "base/settings/settings_target.hpp"

namespace glint {

/// Returns the settings whose names are nearest to `name`, as many as are equally near: keys and, where none is as
/// near, other systems' names. A key is also known by its part after the group, `*.enabled` by its group. Letters' case
/// does not count. Without a near name: the keys whose last part contains `name` or is contained in it. Empty: none.
std::vector<std::string> likelySettings(SettingsTargets targets, std::string_view name);

} // namespace glint
