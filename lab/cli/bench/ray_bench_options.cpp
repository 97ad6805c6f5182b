#include "lab/cli/bench/ray_bench_options.hpp"

#include "base/text.hpp"

#include <charconv>
#include <cmath>

namespace glint::cli {
namespace {

constexpr double kFewestTriangles = 100;
constexpr double kMostTriangles = 1e8; // some 10 GB of host memory
constexpr int64_t kFewestRays = 64;
constexpr int64_t kMostRays = 1 << 20; // their buffer stays within every device's limit

} // namespace

void addRayBenchOptions(CLI::App& command, RayBenchOptions& options) {
    CLI::Option* const rays =
        command.add_flag("--rays", options.asked, "Time the ray back ends instead, on a scene made by code");
    for (const char* other : {"SCENE", "--config", "--set", "--sizes", "--shares", "--frames", "--warm-up", "--budget",
                              "--camera", "--env", "--time", "--seed"})
        rays->excludes(command.get_option(other));
    command
        .add_option("--triangles", options.triangles,
                    "With --rays: of the scene's meshes, a point each; 1e7 takes minutes on a software device")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->needs(rays)
        ->capture_default_str();
    command.add_option("--ray-count", options.rays, "With --rays: of each list (default: 65536; on a GPU 1048576)")
        ->needs(rays);
    command.add_option("--repeats", options.repeats, "With --rays: measurements of each kind, for their median")
        ->needs(rays)
        ->capture_default_str();
}

Result<measure::RayBenchSeries> makeRayBenchSeries(const RayBenchOptions& options) {
    measure::RayBenchSeries series;
    for (const std::string& text : options.triangles) {
        double count = 0;
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, count);
        if (error != std::errc() || rest != end || !(count >= kFewestTriangles && count <= kMostTriangles))
            return invalidArgument("--triangles {}: expected numbers from {:g} to {:g}, as in 1e3,1e6", printable(text),
                                   kFewestTriangles, kMostTriangles);
        series.triangles.push_back(static_cast<uint64_t>(std::llround(count)));
    }
    if (options.rays != 0 && (options.rays < kFewestRays || options.rays > kMostRays))
        return invalidArgument("--ray-count {}: expected {} to {}", options.rays, kFewestRays, kMostRays);
    if (options.repeats < 1 || options.repeats > 1000)
        return invalidArgument("--repeats {}: expected 1 to 1000", options.repeats);
    series.rays = static_cast<uint32_t>(options.rays);
    series.repeats = static_cast<uint32_t>(options.repeats);
    return series;
}

} // namespace glint::cli
