// Benchmarks: points as planned, times of the effect alone, and the requested fraction of mirrors.
#include "gpu/context.hpp"
#include "lab/cli/bench/bench_output.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace glint::test {
namespace bench_test {

render::ProgramSettings settings(const std::vector<std::string>& assignments) {
    return must(render::loadSettings({.defaults = {}, .preset = {}, .file = {}, .assignments = assignments}));
}

TEST(Bench, MeasuresEveryPointForEveryConfig) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = true}));
    measure::BenchScene scene;
    scene.job.scene = "builtin:mirror";
    scene.configs = {{"fine", settings({"screen.march=linear"})},
                     {"coarse", settings({"screen.march=linear", "screen.step=16"})}};
    measure::BenchPlan plan;
    plan.sizes = {{160, 90}, {320, 180}};
    plan.shares = {0, 0.5f, 1};
    plan.warmUp = 1;
    plan.frames = 3;
    const measure::BenchResult result = must(measure::runBench(*context, {scene}, plan));
    for (const std::string& message : context->validationMessages())
        ADD_FAILURE() << "validation: " << message;

    ASSERT_EQ(result.points.size(), 5u);
    for (const measure::BenchPoint& point : result.points) {
        ASSERT_EQ(point.figures.size(), 2u);
        for (const measure::SeriesFigures& figures : point.figures) {
            EXPECT_EQ(figures.times.frames(), 3u);
            EXPECT_GT(figures.times.floor().median, 0);
            EXPECT_GT(figures.times.total().median, 0);
            EXPECT_LE(figures.times.total().median, figures.times.total().p95);
        }
    }
    EXPECT_EQ(result.points[1].plan.width, 320u);
    const auto rays = [&](size_t point) { return double(result.points[point].figures[0].stats.rays); };
    EXPECT_EQ(rays(2), 0);
    EXPECT_GT(rays(4), 30000);
    EXPECT_NEAR(rays(3) / rays(4), 0.5, 0.03);
    const auto& all = result.points[4].figures;
    // Steps are sixteen times as long, but open space takes no samples at either length: 27.3 lookups and 9.2.
    EXPECT_GT(all[0].stats.lookupsPerRay, all[1].stats.lookupsPerRay * 2);
    // Times are compared within a point alone, whose passes take turns: what else the machine does meets all of them.
    // The points follow each other, and under load one of no mirrors took longer than one of nothing else.
    if (context->info().software) {
        EXPECT_GT(all[0].times.floorMultiple(), 2);
        EXPECT_NEAR(all[0].wallMs.median / all[0].times.total().median, 1, 0.5);
    }

    const auto json = nlohmann::json::parse(cli::benchJson(result));
    ASSERT_EQ(json["points"].size(), 5u);
    EXPECT_TRUE(json["points"][0]["share"].is_null());
    EXPECT_EQ(json["points"][3]["share"], 0.5);
    EXPECT_EQ(json["points"][3]["configs"][1]["name"], "coarse");
    const std::string text = cli::benchText(result);
    EXPECT_NE(text.find("builtin:mirror, 320x180, 50 % of the surfaces mirrors"), text.npos) << text;
}

TEST(Bench, ABudgetMeansFewerFrames) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = false}));
    measure::BenchScene scene;
    scene.job.scene = "builtin:mirror";
    scene.configs = {{"balanced", settings({})}};
    measure::BenchPlan plan;
    plan.sizes = {{64, 36}};
    plan.frames = 100000;
    plan.warmUp = 100000;
    plan.budgetSeconds = 0.2;
    const measure::BenchResult result = must(measure::runBench(*context, {scene}, plan));
    EXPECT_GE(result.points[0].figures[0].times.frames(), 1u);
    EXPECT_LT(result.points[0].figures[0].times.frames(), 10000u);
}

} // namespace bench_test
} // namespace glint::test
