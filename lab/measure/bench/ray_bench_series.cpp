#include "lab/measure/bench/ray_bench_series.hpp"

namespace glint::measure {
namespace {

constexpr uint32_t kSoftwareRays = 65536;
constexpr uint32_t kGpuRays = 1048576;
constexpr uint64_t kOneWrongIn = 1000;

} // namespace

Result<RayBenchResult> runRayBench(gpu::Context& context, const RayBenchSeries& series,
                                   const std::function<void(const std::string&)>& progress) {
    RayBenchResult result;
    result.device = context.info().name;
    result.driver = context.info().driver;
    result.software = context.info().software;
    result.rayQuery = context.rayQuery();
    result.series = series;
    if (series.rays == 0)
        result.series.rays = result.software ? kSoftwareRays : kGpuRays;
    context.addShaders(gpu::shaders::render());
    const gpu::AdoptedDevice handles = context.handles();
    GLINT_TRY(library, Context::adopt({handles.instance, handles.physicalDevice, handles.device, handles.queueFamily,
                                       handles.getInstanceProcAddr, handles.rayQuery}));
    for (const uint64_t triangles : series.triangles) {
        if (progress)
            progress(fmt::format("{} triangles", triangles));
        GLINT_TRY(figures, measureRays(context, library, {triangles, result.series.rays, result.series.repeats}));
        result.points.push_back(std::move(figures));
    }
    return result;
}

Result<void> checkSameHits(const RayBenchResult& result) {
    for (const RayBenchFigures& point : result.points)
        if (point.differing() * kOneWrongIn > point.compared())
            return makeError(ErrorCode::Unsupported,
                             "{} triangles: the back ends differ on {} of {} rays, so their times cannot be compared",
                             point.triangles, point.differing(), point.compared());
    return {};
}

} // namespace glint::measure
