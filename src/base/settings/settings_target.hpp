// Settings by name: one table or several, each with the object that it describes. The library's settings and our
// renderer's are two targets, so that a command line, a JSON file and a panel show one list.
#pragma once

#include "base/result.hpp"
#include "glint/setting_info.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct SettingsTarget {
    std::span<const SettingInfo> table;
    void* object = nullptr; ///< the struct that the table's offsets count from
};
using SettingsTargets = std::span<const SettingsTarget>;

/// A value as it was written. JSON says which kind it is; the command line does not.
struct SettingInput {
    enum class Kind { Any, Bool, Number, String, List }; ///< List: numbers with commas between, without the brackets
    std::string_view text;
    Kind kind = Kind::Any;
};

/// What a name and a value come to. An alias may set several settings; the ones that it only implies say so.
struct SettingAssignment {
    const SettingInfo* info = nullptr;
    void* object = nullptr;
    double value = 0; ///< in range, as in SettingInfo::defaultValue
    bool implied = false;
    std::optional<double> insteadOf; ///< assigned only where this is the value so far
};

double settingValue(const SettingInfo& info, const void* object);

/// The value as `--set` takes it: "0.1", "true", "linear". Floats are the shortest text that reads back to their bits.
std::string settingText(const SettingInfo& info, double value);

/// Finds the settings that `name` (a key or an alias) stands for and checks the value; changes nothing.
/// `system`: the preset in force, which decides between systems that share a bare alias.
Result<std::vector<SettingAssignment>> resolveSetting(SettingsTargets targets, std::string_view name,
                                                      const SettingInput& input, std::string_view system);

void assignSettings(std::span<const SettingAssignment> assignments);

/// Resolves and assigns.
Result<void> setSetting(SettingsTargets targets, std::string_view name, std::string_view value,
                        std::string_view system);

/// Errors: the first value out of range.
Result<void> validateSettings(SettingsTargets targets);

} // namespace glint
