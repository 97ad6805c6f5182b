// Parses `glint bench --rays` and its options.
#pragma once

#include "lab/measure/bench/ray_bench_series.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace glint::cli {

/// The options as the user wrote them; makeRayBenchSeries checks them.
struct RayBenchOptions {
    bool asked = false; ///< --rays
    std::vector<std::string> triangles = {"1e3", "1e4", "1e5", "1e6"};
    int64_t rays = 0; ///< 0: the device's default
    int64_t repeats = 5;
};

/// Adds --rays and its options to `glint bench`, whose own options must already exist: those for scenes and images are
/// rejected together with --rays.
void addRayBenchOptions(CLI::App& command, RayBenchOptions& options);

/// Errors: InvalidArgument names the option.
Result<measure::RayBenchSeries> makeRayBenchSeries(const RayBenchOptions& options);

} // namespace glint::cli
