// Implements `glint bench`: times settings over image sizes and over the fraction of the image that reflects.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/measure/bench/bench_series.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::measure {

struct BenchConfig {
    std::string name; ///< as the user wrote it
    render::ProgramSettings settings;
};

struct BenchScene {
    render::RenderJob job; ///< its settings are ignored
    std::vector<BenchConfig> configs;
};

struct BenchPlan {
    std::vector<glm::uvec2> sizes; ///< pixels; empty: the device's defaults
    std::vector<float> shares;     ///< [0, 1], measured at the size nearest to 1280x720
    uint32_t warmUp = 10;
    uint32_t frames = 30;
    double budgetSeconds = 0; ///< per point; 0: no limit
};

/// One scene at one size, with its own materials or with a share of mirrors.
struct BenchPoint {
    std::string scene;
    SeriesPlan plan;
    std::vector<SeriesFigures> figures; ///< in the order of the configs
};

struct BenchResult {
    std::string device;
    std::string driver;
    bool software = false;
    BenchPlan plan; ///< with the sizes that were measured
    std::vector<std::string> configs;
    std::vector<BenchPoint> points;
};

/// Returns 360p, 720p, 1080p and 2160p; for a software device only the first two.
std::vector<glm::uvec2> benchSizes(bool software);

/// `progress`  is called with each point before it is measured; may be empty
/// Errors: those of the scenes' readers and the device.
Result<BenchResult> runBench(gpu::Context& context, const std::vector<BenchScene>& scenes, const BenchPlan& plan,
                             const std::function<void(const std::string&)>& progress = {});

} // namespace glint::measure
