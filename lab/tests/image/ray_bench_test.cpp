// Times of the ray back ends: every figure is present, both hit with the same rays, and the scene has the requested
// triangles.
#include "gpu/context.hpp"
#include "lab/cli/bench/ray_bench_output.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace glint::test {
namespace ray_bench_test {

TEST(RayBench, TimesEveryBackEndOnTheSameRays) {
    const std::unique_ptr<gpu::Context> context = must(gpu::Context::create({.device = {}, .validation = true}));
    const measure::RayBenchResult result =
        must(measure::runRayBench(*context, {.triangles = {1000, 3000}, .rays = 1024, .repeats = 2}));
    for (const std::string& message : context->validationMessages())
        ADD_FAILURE() << "validation: " << message;

    ASSERT_EQ(result.points.size(), 2u);
    EXPECT_NEAR(double(result.points[0].triangles), 1000, 50);
    EXPECT_NEAR(double(result.points[1].triangles), 3000, 150);
    for (const measure::RayBenchFigures& point : result.points) {
        ASSERT_EQ(point.backends.size(), context->rayQuery() ? 2u : 1u);
        EXPECT_EQ(point.backends.back().backend, RayBackend::Bvh);
        for (const measure::RayBackendFigures& figures : point.backends) {
            EXPECT_EQ(figures.refused, "");
            EXPECT_GT(figures.createMs, 0);
            EXPECT_GT(figures.build.wallMs, 0);
            EXPECT_GT(figures.move.wallMs, 0);
            EXPECT_GT(figures.deform.wallMs, 0);
            EXPECT_GT(figures.bytes, point.triangles * 12);
            EXPECT_GT(figures.mostBytes, figures.bytes);
            EXPECT_EQ(figures.camera.rays, 1024u);
            EXPECT_EQ(figures.bounce.rays, 1024u);
            for (const auto* trace : {&figures.camera, &figures.bounce, &figures.changed}) {
                EXPECT_GT(trace->met, trace->rays / 10);
                EXPECT_LT(trace->met, trace->rays);
                EXPECT_GT(trace->wallMs.median, 0);
                EXPECT_EQ(trace->differ.has_value(), &figures != &point.backends.front());
            }
            EXPECT_NE(figures.changed.met, figures.camera.met) << "the scene did not change";
        }
        EXPECT_LE(point.differing(), 2u);
    }
    EXPECT_TRUE(measure::checkSameHits(result));

    const auto json = nlohmann::json::parse(cli::rayBenchJson(result));
    ASSERT_EQ(json["points"].size(), 2u);
    const auto& last = json["points"][1]["backends"].back();
    EXPECT_EQ(last["name"], "bvh");
    EXPECT_GT(last["camera"]["raysPerSecond"], 0);
    EXPECT_EQ(last["camera"]["differ"].is_null(), !context->rayQuery());
    EXPECT_EQ(cli::rayBenchText(result).find("no ray queries") == std::string::npos, context->rayQuery());
}

TEST(RayBench, WithoutRayQueriesTheHierarchyAloneIsTimed) {
    const std::unique_ptr<gpu::Context> context =
        must(gpu::Context::create({.device = {}, .validation = false, .rayQuery = false}));
    const measure::RayBenchResult result =
        must(measure::runRayBench(*context, {.triangles = {1000}, .rays = 64, .repeats = 1}));
    ASSERT_EQ(result.points[0].backends.size(), 1u);
    EXPECT_EQ(result.points[0].backends[0].backend, RayBackend::Bvh);
    EXPECT_NE(cli::rayBenchText(result).find("no ray queries: only bvh is timed"), std::string::npos);
}

TEST(RayBench, OtherHitsAreAnError) {
    measure::RayBenchResult result;
    measure::RayBackendFigures figures;
    figures.camera.rays = 10000;
    figures.camera.differ = 10;
    result.points.resize(1);
    result.points[0].backends = {figures};
    EXPECT_TRUE(measure::checkSameHits(result));
    result.points[0].backends[0].camera.differ = 11;
    EXPECT_FALSE(measure::checkSameHits(result));
}

} // namespace ray_bench_test
} // namespace glint::test
