// The keys of compute_ssr's viewer that change settings without a panel: V and the digits.
#pragma once

#include "lab/view/settings_model.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace glint::view {

/// The views that V cycles through.
constexpr std::array<std::string_view, 5> kCycledViews = {"composite", "scene", "reflection", "normal", "depth"};

/// Returns the view after `view`; the first one if `view` is not in the list.
std::string_view nextView(std::string_view view);

/// Keys 1 2 intensity, 3 4 distance, 5 6 thickness, 7 8 base steps, 9 0 scale of the reflections: decrease and
/// increase.
struct SsrKey {
    char less;
    char more;
    std::string_view name;    ///< compute_ssr's name
    std::string_view setting; ///< Glint's setting
    double step = 0;          ///< added to the value; 0: `factor` multiplies it
    double factor = 1;
    double min = 0; ///< limits of the keys, in addition to the setting's own range
    double max = 0;
};
constexpr std::array<SsrKey, 5> kSsrKeys = {{
    {'1', '2', "Intensity", "reflect.strength", 0.1, 1, 0, 10},
    {'3', '4', "Distance", "screen.maxDistance", 0, 1.25, 0.1, 1e6},
    {'5', '6', "Thickness", "screen.thickness", 0, 1.25, 0.001, 1e3},
    {'7', '8', "Base steps", "adaptive.steps", 8, 1, 1, 128},
    {'9', '0', "SSR scale", "screen.resolutionScale", 0.1, 1, 0.5, 1},
}};

/// Applies the key of a digit. Returns the message to show ("Intensity 1.1"), or no value for other keys.
std::optional<std::string> pressSsrKey(char digit, SettingsModel& model);

} // namespace glint::view
