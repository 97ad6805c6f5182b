#include "lab/cli/bench/bench_output.hpp"

#include "lab/cli/compare/comparison_output.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
using measure::BenchPoint;
using measure::BenchResult;

double rayShare(const BenchPoint& point, const measure::SeriesFigures& figures) {
    return static_cast<double>(figures.stats.rays) / (double(point.plan.width) * double(point.plan.height));
}

std::string pointTitle(const BenchPoint& point) {
    const std::string share =
        point.plan.share ? fmt::format(", {:g} % of the surfaces mirrors", 100 * *point.plan.share) : std::string();
    return fmt::format("{}, {}x{}{}", point.scene, point.plan.width, point.plan.height, share);
}

std::string configLine(const BenchPoint& point, const std::string& name, size_t nameWidth, size_t i) {
    const measure::SeriesFigures& f = point.figures[i];
    const double first = point.figures.front().times.total().median;
    const double ratio = first > 0 ? f.times.total().median / first : 1;
    return fmt::format("  {:<{}}  {:>9.3f}  {:>9.3f}  {:>7.1f}  {:>6.2f}  {:>9.3f}  {:>7.1f}  {:>5}  {:>6.1f}  {:>6}\n",
                       name, nameWidth, f.times.total().median, f.times.total().p95, f.times.floorMultiple(), ratio,
                       f.wallMs.median, f.stats.lookupsPerRay, f.stats.lookups95, 100 * rayShare(point, f),
                       f.times.frames());
}

std::string passesLine(const std::string& name, size_t nameWidth, const measure::EffectTimes& times) {
    std::string text = fmt::format("  {:<{}}  passes:", name, nameWidth);
    for (const measure::PassSpread& pass : times.passes())
        text += fmt::format(" {} {:.3f}", pass.name, pass.ms.median);
    return text + fmt::format("; floor {:.3f}\n", times.floor().median);
}

Json figuresJson(const BenchPoint& point, const std::string& name, const measure::SeriesFigures& figures) {
    Json json;
    json["name"] = name;
    json["frames"] = figures.times.frames();
    json["effectMs"] = figures.times.total().median;
    json["effectMs95"] = figures.times.total().p95;
    json["wallMs"] = figures.wallMs.median;
    json["wallMs95"] = figures.wallMs.p95;
    json["floorMs"] = figures.times.floor().median;
    json["floorMultiple"] = figures.times.floorMultiple();
    Json passes = Json::array();
    for (const measure::PassSpread& pass : figures.times.passes())
        passes.push_back({{"name", pass.name}, {"ms", pass.ms.median}, {"ms95", pass.ms.p95}});
    json["passes"] = std::move(passes);
    json["rays"] = figures.stats.rays;
    json["rayShare"] = rayShare(point, figures);
    json["lookupsPerRay"] = figures.stats.lookupsPerRay;
    json["lookups95"] = figures.stats.lookups95;
    Json outcomes = Json::object();
    for (const auto& [outcome, pixels] : figures.stats.outcomes)
        outcomes[outcome] = pixels;
    json["outcomes"] = std::move(outcomes);
    return json;
}

} // namespace

std::string benchText(const BenchResult& result) {
    std::string text = fmt::format("{}; {}; {}\n", result.device, clockWords(result.software),
                                   result.software ? "the effect alone, over a G-buffer drawn once" : "whole frames");
    size_t nameWidth = 8;
    for (const std::string& name : result.configs)
        nameWidth = std::max(nameWidth, name.size());
    for (const BenchPoint& point : result.points) {
        text += fmt::format("\n{}\n  {:<{}}  {:>9}  {:>9}  {:>7}  {:>6}  {:>9}  {:>7}  {:>5}  {:>6}  {:>6}\n",
                            pointTitle(point), "", nameWidth, "effect ms", "95 %", "floors", "ratio", "wall ms",
                            "lookups", "95 %", "rays %", "frames");
        for (size_t i = 0; i < result.configs.size(); ++i)
            text += configLine(point, result.configs[i], nameWidth, i);
        for (size_t i = 0; i < result.configs.size(); ++i)
            text += passesLine(result.configs[i], nameWidth, point.figures[i].times);
    }
    return text;
}

std::string benchCheckText(const std::vector<measure::CheckedFigure>& checked, const std::string& baseDevice,
                           const std::string& device) {
    std::string text;
    if (device != baseDevice)
        text = fmt::format("{}; the base is of {}: floors are not compared\n", device, baseDevice);
    for (const measure::CheckedFigure& figure : checked) {
        const std::string share =
            figure.base.share ? fmt::format(", {:g} % mirrors", 100 * *figure.base.share) : std::string();
        text += fmt::format("{}, {}x{}{}, {}: {:.1f} floors, base {:.1f}{}; {:.1f} lookups, base {:.1f}{}\n",
                            figure.base.scene, figure.base.size.x, figure.base.size.y, share, figure.base.config,
                            figure.now.floors, figure.base.floors, figure.slower ? ": SLOWER" : "", figure.now.lookups,
                            figure.base.lookups, figure.moreLookups ? ": MORE" : "");
    }
    return text;
}

std::string benchJson(const BenchResult& result) {
    Json json;
    json["device"] = {{"name", result.device}, {"driver", result.driver}, {"software", result.software}};
    json["clock"] = clockWords(result.software);
    json["frames"] = result.plan.frames;
    json["warmUp"] = result.plan.warmUp;
    json["points"] = Json::array();
    for (const BenchPoint& point : result.points) {
        Json entry;
        entry["scene"] = point.scene;
        entry["width"] = point.plan.width;
        entry["height"] = point.plan.height;
        entry["share"] = point.plan.share ? Json(*point.plan.share) : Json();
        entry["wholeFrames"] = point.plan.redraw;
        entry["configs"] = Json::array();
        for (size_t i = 0; i < result.configs.size(); ++i)
            entry["configs"].push_back(figuresJson(point, result.configs[i], point.figures[i]));
        json["points"].push_back(std::move(entry));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
