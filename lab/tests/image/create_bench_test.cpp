// Times of creating the library's objects: each figure is present, and what is shared costs less.
#include "gpu/context.hpp"
#include "lab/cli/bench/create_bench_output.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace glint::test {
namespace create_bench_test {

TEST(CreateBench, TimesTheFirstObjectAndThoseThatShareItsPipelines) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = true}));
    measure::CreatePlan plan;
    plan.width = 64;
    plan.height = 36;
    plan.repeats = 2;
    plan.configs.push_back({"screen", Settings()});
    Settings rays;
    rays.rays.enabled = true;
    rays.rays.backend = RayBackend::Bvh;
    plan.configs.push_back({"rays", rays});
    std::vector<std::string> told;
    const measure::CreateResult result =
        must(measure::measureCreation(*context, plan, [&](const std::string& text) { told.push_back(text); }));
    for (const std::string& message : context->validationMessages())
        ADD_FAILURE() << "validation: " << message;
    EXPECT_EQ(told, (std::vector<std::string>{"screen", "rays"}));
    ASSERT_EQ(result.figures.size(), 2u);
    for (const measure::CreateFigures& figures : result.figures) {
        EXPECT_GT(figures.reflections.cachedMs, 0);
        EXPECT_LT(figures.reflections.againMs, 0.5 * figures.reflections.firstMs) << "nothing is compiled again";
        EXPECT_GT(figures.resizeMs, 0);
        EXPECT_LT(figures.resizeMs, 0.5 * figures.reflections.firstMs);
        EXPECT_GT(figures.pipelineBytes, 0u) << "a header at least";
    }
    EXPECT_FALSE(result.figures[0].rays);
    EXPECT_EQ(result.figures[0].setRays.firstMs, 0);
    EXPECT_TRUE(result.figures[1].rays);
    EXPECT_GT(result.figures[1].setRays.firstMs, 10 * result.figures[1].setRays.againMs);

    const auto json = nlohmann::json::parse(cli::createBenchJson(result));
    ASSERT_EQ(json["configs"].size(), 2u);
    EXPECT_TRUE(json["configs"][0]["setRays"].is_null());
    EXPECT_EQ(json["configs"][1]["setRays"]["firstMs"], result.figures[1].setRays.firstMs);
    EXPECT_EQ(json["width"], 64);
    const std::string text = cli::createBenchText(result);
    EXPECT_NE(text.find("setRays"), std::string::npos);
    EXPECT_NE(text.find("64x36"), std::string::npos);
}

TEST(CreateBench, WrongSettingsAreAnError) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = false}));
    measure::CreatePlan plan;
    plan.configs.push_back({"wrong", Settings()});
    plan.configs.back().settings.screen.maxSteps = 0;
    const auto result = measure::measureCreation(*context, plan);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("screen.maxSteps"), std::string::npos) << result.error().message;
}

} // namespace create_bench_test
} // namespace glint::test
