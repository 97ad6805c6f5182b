// Reads the curve of cost against error that `glint tune --json` wrote (docs/tune.md).
#pragma once

#include "base/result.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace glint::cli {

/// Returns what a report shows of the file, with every value checked:
/// {"file", "device", "scenes": [...], "size": [w, h], "start", "preset", "unit", "points": [{"assignments":
/// ["KEY=VALUE"],
///  "cost", "error", "heldError" (or null), "preset" (or null), "chosen"}], "presets": [{"name", "cost", "error"}],
///  "sensitivities": [{"setting", "error", "cost"}]}
/// A point's assignments make its settings of the preset. A file without "startPreset" has the preset in "start".
/// Errors: NotFound, Io; InvalidInput names `--curve`, the file and the value.
Result<nlohmann::ordered_json> readCurve(const std::string& file);

} // namespace glint::cli
