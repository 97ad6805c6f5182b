// Formats a benchmark as text and as JSON.
#pragma once

#include "lab/measure/bench/bench_check.hpp"

namespace glint::cli {

/// Returns text for the terminal: one table per point.
std::string benchText(const measure::BenchResult& result);

/// {"device": {...}, "clock", "frames", "warmUp", "points": [{"scene", "width", "height", "share" (null: the scene's
///  own), "wholeFrames", "configs": [{"name", "frames", "effectMs", "effectMs95", "wallMs", "wallMs95", "floorMs",
///  "floorMultiple", "passes": [{"name", "ms", "ms95"}], "rays", "rayShare", "lookupsPerRay", "lookups95",
///  "outcomes"}]}]}
std::string benchJson(const measure::BenchResult& result);

/// Returns a line for each figure, with the base's beside it.
std::string benchCheckText(const std::vector<measure::CheckedFigure>& checked, const std::string& baseDevice,
                           const std::string& device);

} // namespace glint::cli
