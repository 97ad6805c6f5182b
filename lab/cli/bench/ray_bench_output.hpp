// Formats times of the ray back ends as text and as JSON.
#pragma once

#include "lab/measure/bench/ray_bench_series.hpp"

#include <string>

namespace glint::cli {

/// Returns text for the terminal: a table of building and changing, a table of tracing.
std::string rayBenchText(const measure::RayBenchResult& result);

/// {"device": {...}, "clock", "rays", "repeats", "points": [{"triangles", "placed", "meshes", "instances", "deformed",
///  "backends": [{"name", "createMs", "refused" (then nothing more) | "build", "move", "deform": {"cpuMs", "wallMs",
///  "gpuMs" (null: unknown)}, "bytes", "mostBytes", "camera", "bounce", "changed": {"rays", "met", "wallMs",
///  "wallMs95", "gpuMs", "gpuMs95", "raysPerSecond", "differ" (null: nothing to compare with)}}]}]}
std::string rayBenchJson(const measure::RayBenchResult& result);

} // namespace glint::cli
