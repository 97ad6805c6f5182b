// What `glint bench --rays` measures: both ray back ends on scenes of more and more triangles.
#pragma once

#include "measure/ray_bench.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace glint::cli {

/// As they were written; makeRayBenchSeries checks them.
struct RayBenchOptions {
    bool asked = false; ///< --rays
    std::vector<std::string> triangles = {"1e3", "1e4", "1e5", "1e6"};
    int64_t rays = 0; ///< 0: what suits the device
    int64_t repeats = 5;
};

/// Adds --rays and what goes with it to `glint bench`, which must have its own options by then: those about scenes and
/// pictures are refused beside it.
void addRayBenchOptions(CLI::App& command, RayBenchOptions& options);

struct RayBenchSeries {
    std::vector<uint64_t> triangles; ///< a point each
    uint32_t rays = 0;               ///< of each list; 0: what suits the device
    uint32_t repeats = 5;
};

/// Errors: InvalidArgument names the option.
Result<RayBenchSeries> makeRayBenchSeries(const RayBenchOptions& options);

struct RayBenchResult {
    std::string device;
    std::string driver;
    bool software = false;
    bool rayQuery = false; ///< else only Bvh was timed
    RayBenchSeries series; ///< with the number of rays that were asked for
    std::vector<measure::RayBenchFigures> points;
};

/// `progress`  is told each point before it is measured; may be empty
/// Errors: as measure::measureRays gives them.
Result<RayBenchResult> runRayBench(gpu::Context& context, const RayBenchSeries& series,
                                   const std::function<void(const std::string&)>& progress = {});

/// Times are worth nothing where the back ends find different hits. Errors: Unsupported for more than one ray in a
/// thousand of a point.
Result<void> checkSameHits(const RayBenchResult& result);

/// For people: a table of building and changing, a table of tracing.
std::string rayBenchText(const RayBenchResult& result);

/// {"device": {...}, "clock", "rays", "repeats", "points": [{"triangles", "placed", "meshes", "instances", "deformed",
///  "backends": [{"name", "createMs", "refused" (then nothing more) | "build", "move", "deform": {"cpuMs", "wallMs",
///  "gpuMs" (null: unknown)}, "bytes", "mostBytes", "camera", "bounce", "changed": {"rays", "met", "wallMs",
///  "wallMs95", "gpuMs", "gpuMs95", "raysPerSecond", "differ" (null: nothing to compare with)}}]}]}
std::string rayBenchJson(const RayBenchResult& result);

} // namespace glint::cli
