#include "lab/cli/bench/bench_costs.hpp"

#include "base/text.hpp"
#include "lab/session/run_job.hpp"

namespace glint::cli {

Result<CostsBench> measureCostTable(gpu::Context& context, const std::vector<measure::BenchScene>& scenes,
                                    const measure::BenchPlan& plan,
                                    const std::function<void(const std::string&)>& progress) {
    const glm::uvec2 size = plan.sizes.empty() ? glm::uvec2(640, 360) : plan.sizes.front();
    GLINT_TRY(floor, measure::FloorPass::create(context, size.x, size.y));
    CostsBench result;
    result.table = tune::costTable();
    std::vector<tune::CostSample> samples;
    std::vector<std::string> names;
    for (const measure::BenchScene& scene : scenes) {
        names.push_back(scene.job.scene);
        for (const measure::BenchConfig& config : scene.configs) {
            render::RenderJob job = scene.job;
            job.settings = config.settings;
            job.width = size.x;
            job.height = size.y;
            job.statistics = true;
            progress(fmt::format("{} {}", scene.job.scene, config.name));
            GLINT_TRY(session, render::openJob(context, job));
            GLINT_TRY(sample, tune::measureCosts(result.table, session, floor, plan.frames));
            if (sample.floors.empty())
                return invalidArgument("{} {}: no times: the device has no timestamps, or the frame has several "
                                       "samples a pixel",
                                       printable(scene.job.scene), printable(config.name));
            sample.name = scene.job.scene + " " + config.name;
            samples.push_back(std::move(sample));
        }
    }
    result.frames = samples.size();
    result.rows = tune::fitCosts(result.table, samples);
    result.withoutRow = tune::passesWithoutRow(result.table, samples);
    size_t fitted = 0;
    for (size_t i = 0; i < result.rows.size(); ++i) {
        result.table.rows[i].floors = result.rows[i].floors;
        fitted += result.rows[i].kept.empty();
    }
    result.table.measured =
        fmt::format("{} of {} rows on {} at {}x{}, {}; the others before: {}", fitted, result.rows.size(),
                    listText(names, " and "), size.x, size.y, context.info().driver, tune::costTable().measured);
    return result;
}

std::string costsBenchText(const CostsBench& result) {
    std::string text = fmt::format("{:<26} {:<11} {:>8} {:>8}\n", "pass", "unit", "before", "now");
    for (const tune::FittedRow& row : result.rows)
        text += fmt::format(
            "{:<26} {:<11} {:>8} {:>8}  {}\n", row.row.pass, row.row.unit->name, row.row.floors, row.floors,
            row.kept.empty() ? fmt::format("fitted, off by {:.0f} %", 100 * row.error) : "kept: " + row.kept);
    for (const std::string& pass : result.withoutRow)
        text += fmt::format("{:<26} has no row: counted as {} floors\n", pass, result.table.otherPass);
    return text + fmt::format("from {} frames\n", result.frames);
}

} // namespace glint::cli
