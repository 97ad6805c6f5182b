// What `glint bench` measures: settings over sizes and over the share of the picture that reflects.
#pragma once

#include "measure/bench_series.hpp"
#include "render/render_job.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::cli {

struct BenchConfig {
    std::string name; ///< as it was written
    render::ProgramSettings settings;
};

struct BenchScene {
    render::RenderJob job; ///< its settings are not used
    std::vector<BenchConfig> configs;
};

struct BenchPlan {
    std::vector<glm::uvec2> sizes; ///< pixels; empty: what suits the device
    std::vector<float> shares;     ///< [0, 1], measured at the size nearest to 1280x720
    uint32_t warmUp = 10;
    uint32_t frames = 30;
    double budgetSeconds = 0; ///< for each point; 0: no limit
};

/// One scene at one size, with its own materials or with a share of mirrors.
struct BenchPoint {
    std::string scene;
    measure::SeriesPlan plan;
    std::vector<measure::SeriesFigures> figures; ///< in the order of the configs
};

struct BenchResult {
    std::string device;
    std::string driver;
    bool software = false;
    BenchPlan plan; ///< with the sizes that were measured
    std::vector<std::string> configs;
    std::vector<BenchPoint> points;
};

/// 360p, 720p, 1080p and 2160p; a software device gets the first two.
std::vector<glm::uvec2> benchSizes(bool software);

/// `progress`  is told each point before it is measured; may be empty
/// Errors: as the scenes' readers and the device give them.
Result<BenchResult> runBench(gpu::Context& context, const std::vector<BenchScene>& scenes, const BenchPlan& plan,
                             const std::function<void(const std::string&)>& progress = {});

/// For people: a table a point.
std::string benchText(const BenchResult& result);

/// {"device": {...}, "clock", "frames", "warmUp", "points": [{"scene", "width", "height", "share" (null: the scene's
///  own), "wholeFrames", "configs": [{"name", "frames", "effectMs", "effectMs95", "wallMs", "wallMs95", "floorMs",
///  "floorMultiple", "passes": [{"name", "ms", "ms95"}], "rays", "rayShare", "lookupsPerRay", "lookups95",
///  "outcomes"}]}]}
std::string benchJson(const BenchResult& result);

} // namespace glint::cli
