#include "lab/cli/bench/ray_bench_output.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
using measure::RayBackendFigures;
using measure::RayBenchFigures;
using measure::RayBenchResult;
using measure::RayTraceTimes;
using measure::RayUpdateTimes;

/// GPU timestamps exclude the CPU's cost of a dispatch, which dominates short ones. A software device uses the CPU's
/// clock throughout and may defer work past a timestamp: wall time is better there.
const measure::Spread& traceMs(const RayTraceTimes& trace, bool software) {
    return software || trace.gpuMs.median <= 0 ? trace.wallMs : trace.gpuMs;
}

double raysPerSecond(const RayTraceTimes& trace, bool software) {
    const double ms = traceMs(trace, software).median;
    return ms > 0 ? 1e3 * static_cast<double>(trace.rays) / ms : 0;
}

const char* clockOf(bool software) {
    return software ? "a software device: all by the wall clock, on the device from submitting to done"
                    : "tracing by GPU timestamps, all else by the wall clock, on the device from submitting to done";
}

const char* nameOf(RayBackend backend) {
    return backend == RayBackend::Query ? "query" : "bvh";
}

double mebibytes(size_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

std::string rowStart(const RayBenchFigures& point, const RayBackendFigures& figures) {
    return fmt::format("  {:>9}  {:>9}  {:<8}", point.triangles, point.placed, nameOf(figures.backend));
}

std::string changeRow(const RayBenchFigures& point, const RayBackendFigures& f) {
    if (!f.refused.empty())
        return rowStart(point, f) + fmt::format("  {:>10.1f}  then refused: {}\n", f.createMs, f.refused);
    return rowStart(point, f) + fmt::format("  {:>10.1f}  {:>8.1f}  {:>7.1f}  {:>8.1f}  {:>8.2f}  {:>8.2f}  {:>10.1f}  "
                                            "{:>9.1f}\n",
                                            f.createMs, f.build.cpuMs + f.build.wallMs, mebibytes(f.bytes),
                                            mebibytes(f.mostBytes), f.move.cpuMs, f.move.wallMs, f.deform.cpuMs,
                                            f.deform.wallMs);
}

std::string differText(const RayTraceTimes& trace) {
    return trace.differ ? fmt::format("{}", *trace.differ) : "-";
}

std::string traceRow(const RayBenchFigures& point, const RayBackendFigures& f, bool software) {
    if (!f.refused.empty())
        return {};
    std::string row = rowStart(point, f);
    for (const RayTraceTimes* trace : {&f.camera, &f.bounce})
        row += fmt::format(
            "  {:>10.2f}  {:>8.3f}  {:>5.1f}", traceMs(*trace, software).median, 1e-6 * raysPerSecond(*trace, software),
            100 * static_cast<double>(trace->met) / static_cast<double>(std::max<uint64_t>(trace->rays, 1)));
    return row +
           fmt::format("  {:>6}  {:>6}  {:>7}\n", differText(f.camera), differText(f.bounce), differText(f.changed));
}

Json updateJson(const RayUpdateTimes& times) {
    return {{"cpuMs", times.cpuMs}, {"wallMs", times.wallMs}, {"gpuMs", times.gpuMs > 0 ? Json(times.gpuMs) : Json()}};
}

Json traceJson(const RayTraceTimes& trace, bool software) {
    const bool stamped = trace.gpuMs.median > 0;
    return {{"rays", trace.rays},
            {"met", trace.met},
            {"wallMs", trace.wallMs.median},
            {"wallMs95", trace.wallMs.p95},
            {"gpuMs", stamped ? Json(trace.gpuMs.median) : Json()},
            {"gpuMs95", stamped ? Json(trace.gpuMs.p95) : Json()},
            {"raysPerSecond", raysPerSecond(trace, software)},
            {"differ", trace.differ ? Json(*trace.differ) : Json()}};
}

Json backendJson(const RayBackendFigures& figures, bool software) {
    Json json;
    json["name"] = nameOf(figures.backend);
    json["createMs"] = figures.createMs;
    if (!figures.refused.empty()) {
        json["refused"] = figures.refused;
        return json;
    }
    json["build"] = updateJson(figures.build);
    json["move"] = updateJson(figures.move);
    json["deform"] = updateJson(figures.deform);
    json["bytes"] = figures.bytes;
    json["mostBytes"] = figures.mostBytes;
    json["camera"] = traceJson(figures.camera, software);
    json["bounce"] = traceJson(figures.bounce, software);
    json["changed"] = traceJson(figures.changed, software);
    return json;
}

} // namespace

std::string rayBenchText(const RayBenchResult& result) {
    const RayBenchFigures& first = result.points.front();
    std::string text =
        fmt::format("{}; {}\n"
                    "a terrain and a heap of dented balls: {} meshes, {} instances; medians of {}\n",
                    result.device, clockOf(result.software), first.meshes, first.instances, result.series.repeats);
    if (!result.rayQuery)
        text += "this device has no ray queries: only bvh is timed, and its hits are compared with no others\n";
    text +=
        fmt::format("\nbuilding, moving all balls, deforming an eighth of the triangles; ms of the CPU, then of the "
                    "device\n  {:>9}  {:>9}  {:<8}  {:>10}  {:>8}  {:>7}  {:>8}  {:>8}  {:>8}  {:>10}  {:>9}\n",
                    "triangles", "placed", "back end", "create CPU", "build", "MiB", "most MiB", "move CPU", "device",
                    "deform CPU", "device");
    for (const RayBenchFigures& point : result.points)
        for (const RayBackendFigures& figures : point.backends)
            text += changeRow(point, figures);
    text +=
        fmt::format("\ntracing {} rays of a camera and as many diffuse bounces; differ: hits that the other back end "
                    "does not find\n  {:>9}  {:>9}  {:<8}  {:>10}  {:>8}  {:>5}  {:>10}  {:>8}  {:>5}  {:>6}  {:>6}  "
                    "{:>7}\n",
                    first.backends.front().camera.rays, "triangles", "placed", "back end", "camera ms", "Mrays/s",
                    "hit %", "bounce ms", "Mrays/s", "hit %", "differ", "bounce", "changed");
    for (const RayBenchFigures& point : result.points)
        for (const RayBackendFigures& figures : point.backends)
            text += traceRow(point, figures, result.software);
    return text;
}

std::string rayBenchJson(const RayBenchResult& result) {
    Json json;
    json["device"] = {{"name", result.device},
                      {"driver", result.driver},
                      {"software", result.software},
                      {"rayQuery", result.rayQuery}};
    json["clock"] = clockOf(result.software);
    json["rays"] = result.series.rays;
    json["repeats"] = result.series.repeats;
    json["points"] = Json::array();
    for (const RayBenchFigures& point : result.points) {
        Json entry = {{"triangles", point.triangles}, {"placed", point.placed},     {"meshes", point.meshes},
                      {"instances", point.instances}, {"deformed", point.deformed}, {"backends", Json::array()}};
        for (const RayBackendFigures& figures : point.backends)
            entry["backends"].push_back(backendJson(figures, result.software));
        json["points"].push_back(std::move(entry));
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
