// Formats the result of a search as text, as JSON and as a settings file.
#pragma once

#include "lab/job/program_settings.hpp"
#include "lab/tune/tune.hpp"

#include <string>
#include <vector>

namespace glint::cli {

/// The options that the output repeats.
struct TuneNames {
    std::vector<std::string> scenes;
    std::string start;
    uint32_t seed = 0;
    render::ProgramSettings settings = {}; ///< the start's, with those of the renderer
    render::ProgramSettings preset = {};   ///< those of its preset alone
};

/// Returns text for the terminal: the curve, the presets, the choice and what mattered.
std::string tuneText(const tune::TuneResult& result, const TuneNames& names);

/// The error where the choice does not meet the target.
Error missedTarget(const tune::TuneResult& result);

/// {"glint", "device", "driver", "scenes", "size": [w, h], "seed", "generations", "tried", "start",
///  "startPreset", "startSettings": {key: value}, "cost": {"unit": "floors"|"ms", "counted"}, "metric":
///  "flip"|"relativeMSE", "target": {"cost"|"error"}, "met", "heldUp", "points": [{"settings": {key: value}, "cost",
///  "error", "held": {"cost", "error"}, "preset", "chosen",
///    "measured": {"floors", "ms"}, "views": [{"view", "cost", "error"}]}],
///  "choice": as a point, "presets": [{"name", "cost", "error", "held", "measured"}],
///  "sensitivities": [{"setting", "value", "start", "error", "cost"}], "withoutEffect": [keys]}
/// Points are ordered by cost, and none is dominated. "settings" has what differs from the start, and
/// "startSettings" what of the start differs from its preset.
std::string tuneJson(const tune::TuneResult& result, const TuneNames& names);

/// Returns a settings file for `--settings`: what differs from the default preset, so that it stands alone.
std::string tunedSettings(const tune::TuneResult& result, const TuneNames& names);

} // namespace glint::cli
