#include "lab/measure/bench/bench.hpp"

#include "lab/session/run_job.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

/// Creates one session per config of a scene, so that the configs can take turns.
Result<std::vector<render::ReflectionSession>> makeSessions(gpu::Context& context, const BenchScene& scene,
                                                            glm::uvec2 size) {
    std::vector<render::ReflectionSession> sessions;
    for (const BenchConfig& config : scene.configs) {
        render::RenderJob job = scene.job;
        job.settings = config.settings;
        job.width = size.x;
        job.height = size.y;
        job.statistics = false; // as a host ships
        job.libraryViews = false;
        GLINT_TRY(session, render::openJob(context, job));
        sessions.push_back(std::move(session));
    }
    return sessions;
}

/// Shares are measured at one size: the one whose pixel count is nearest to that of 1280x720, by ratio.
glm::uvec2 shareSize(const std::vector<glm::uvec2>& sizes) {
    const auto distance = [](const glm::uvec2& size) {
        return std::abs(std::log(double(size.x) * double(size.y) / (1280.0 * 720.0)));
    };
    return *std::ranges::min_element(sizes, {}, distance);
}

} // namespace

std::vector<glm::uvec2> benchSizes(bool software) {
    if (software)
        return {{640, 360}, {1280, 720}};
    return {{640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}};
}

Result<BenchResult> runBench(gpu::Context& context, const std::vector<BenchScene>& scenes, const BenchPlan& plan,
                             const std::function<void(const std::string&)>& progress) {
    BenchResult result;
    result.device = context.info().name;
    result.driver = context.info().driver;
    result.software = context.info().software;
    result.plan = plan;
    if (plan.sizes.empty())
        result.plan.sizes = benchSizes(result.software);
    for (const BenchConfig& config : scenes.front().configs)
        result.configs.push_back(config.name);

    for (const BenchScene& scene : scenes) {
        GLINT_TRY(sessions, makeSessions(context, scene, result.plan.sizes.front()));
        const auto measurePoint = [&](glm::uvec2 size, std::optional<float> share) -> Result<void> {
            BenchPoint point;
            point.scene = scene.job.scene;
            point.plan = {size.x, size.y, share, plan.warmUp, plan.frames, plan.budgetSeconds, !result.software};
            if (progress)
                progress(fmt::format("{} {}x{}{}", point.scene, size.x, size.y,
                                     share ? fmt::format(" {:g} %", 100 * *share) : std::string()));
            GLINT_TRY(figures, runSeries(context, sessions, point.plan));
            point.figures = std::move(figures);
            result.points.push_back(std::move(point));
            return {};
        };
        for (const glm::uvec2& size : result.plan.sizes)
            GLINT_CHECK(measurePoint(size, std::nullopt));
        for (const float share : plan.shares)
            GLINT_CHECK(measurePoint(shareSize(result.plan.sizes), share));
    }
    return result;
}

} // namespace glint::measure
