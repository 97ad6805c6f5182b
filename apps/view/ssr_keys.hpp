// The keys of compute_ssr's viewer, which tune without a panel: V and the digits.
#pragma once

#include "settings_model.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace glint::view {

/// What V goes through.
constexpr std::array<std::string_view, 5> kCycledViews = {"composite", "scene", "reflection", "normal", "depth"};

/// The view after `view`; the first one where that is none of them.
std::string_view nextView(std::string_view view);

/// 1 2 intensity, 3 4 distance, 5 6 thickness, 7 8 base steps, 9 0 scale of the reflections: less and more.
struct SsrKey {
    char less;
    char more;
    std::string_view name;    ///< compute_ssr's
    std::string_view setting; ///< ours
    double step = 0;          ///< added; 0: `factor` multiplies
    double factor = 1;
    double min = 0; ///< what the keys stay inside, besides the setting's own range
    double max = 0;
};
constexpr std::array<SsrKey, 5> kSsrKeys = {{
    {'1', '2', "Intensity", "reflect.strength", 0.1, 1, 0, 10},
    {'3', '4', "Distance", "screen.maxDistance", 0, 1.25, 0.1, 1e6},
    {'5', '6', "Thickness", "screen.thickness", 0, 1.25, 0.001, 1e3},
    {'7', '8', "Base steps", "adaptive.steps", 8, 1, 1, 128},
    {'9', '0', "SSR scale", "screen.resolutionScale", 0.1, 1, 0.5, 1},
}};

/// Changes what the digit stands for. Returns what is to be said ("Intensity 1.1"), or nothing for other keys.
std::optional<std::string> pressSsrKey(char digit, SettingsModel& model);

} // namespace glint::view
