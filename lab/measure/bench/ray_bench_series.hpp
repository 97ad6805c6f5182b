// Implements `glint bench --rays`: times both ray back ends on scenes of increasing triangle counts.
#pragma once

#include "lab/measure/bench/ray_bench.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::measure {

struct RayBenchSeries {
    std::vector<uint64_t> triangles; ///< one point each
    uint32_t rays = 0;               ///< per list; 0: the device's default
    uint32_t repeats = 5;
};

struct RayBenchResult {
    std::string device;
    std::string driver;
    bool software = false;
    bool rayQuery = false; ///< false: only Bvh was timed
    RayBenchSeries series; ///< with the number of rays that was used
    std::vector<RayBenchFigures> points;
};

/// `progress`  is called with each point before it is measured; may be empty
/// Errors: as measureRays.
Result<RayBenchResult> runRayBench(gpu::Context& context, const RayBenchSeries& series,
                                   const std::function<void(const std::string&)>& progress = {});

/// Times are meaningless if the back ends find different hits. Errors: Unsupported if more than one ray in a thousand
/// of a point differs.
Result<void> checkSameHits(const RayBenchResult& result);

} // namespace glint::measure
