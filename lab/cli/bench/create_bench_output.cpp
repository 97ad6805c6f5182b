#include "lab/cli/bench/create_bench_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
using measure::CreateFigures;
using measure::CreateTimes;

std::string row(const std::string& config, const char* call, const CreateTimes& times) {
    return fmt::format("  {:<40}  {:<8}  {:>9.1f}  {:>11.1f}  {:>9.2f}", config, call, times.firstMs, times.cachedMs,
                       times.againMs);
}

Json timesJson(const CreateTimes& times) {
    return {{"firstMs", times.firstMs}, {"cachedMs", times.cachedMs}, {"againMs", times.againMs}};
}

} // namespace

std::string createBenchText(const measure::CreateResult& result) {
    std::string text =
        fmt::format("{}; {}; {}x{}, medians of {} but for the first, ms of the calls\n\n"
                    "  {:<40}  {:<8}  {:>9}  {:>11}  {:>9}  {:>9}  {:>9}\n",
                    result.device, result.driver, result.plan.width, result.plan.height, result.plan.repeats, "config",
                    "call", "first", "from cache", "again", "resize", "cache kB");
    for (const CreateFigures& figures : result.figures) {
        text +=
            row(figures.config, "create", figures.reflections) +
            fmt::format("  {:>9.2f}  {:>9.1f}\n", figures.resizeMs, 1e-3 * static_cast<double>(figures.pipelineBytes));
        if (figures.rays)
            text += row("", "setRays", figures.setRays) + "\n";
    }
    return text;
}

std::string createBenchJson(const measure::CreateResult& result) {
    Json json;
    json["device"] = {{"name", result.device}, {"driver", result.driver}};
    json["width"] = result.plan.width;
    json["height"] = result.plan.height;
    json["repeats"] = result.plan.repeats;
    json["configs"] = Json::array();
    for (const CreateFigures& figures : result.figures)
        json["configs"].push_back({{"name", figures.config},
                                   {"create", timesJson(figures.reflections)},
                                   {"setRays", figures.rays ? timesJson(figures.setRays) : Json()},
                                   {"resizeMs", figures.resizeMs},
                                   {"pipelineCacheBytes", figures.pipelineBytes}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
