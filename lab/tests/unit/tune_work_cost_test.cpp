// The counted cost grows with what a frame did.
#include "lab/tune/work_cost.hpp"

#include <gtest/gtest.h>

namespace glint::tune {
namespace tune_work_cost_test {

class TuneWorkCost : public testing::Test {
protected:
    TuneWorkCost() {
        work_.settings = &settings_;
        work_.pixels = 10000;
        work_.rough.add(0.3f, 0.25);
        work_.rough.add(0.6f, 0.25);
        work_.triangles = 1000;
        work_.stats.rays = 5000;
        work_.stats.lookupsPerRay = 20;
        work_.passes = {"trace/hiz", "composite/statistics"};
    }
    double floors() const { return countedFloors(work_); }

    Settings settings_;
    FrameWork work_;
};

TEST_F(TuneWorkCost, TracingCostsItsLookups) {
    const double once = floors();
    work_.stats.lookupsPerRay = 40;
    const double twice = floors();
    EXPECT_GT(twice, once * 1.5);
    EXPECT_LT(twice, once * 2);
    work_.stats.rays = 10000;
    EXPECT_DOUBLE_EQ(floors(), twice * 2);
}

TEST_F(TuneWorkCost, FiguresAreNoPartOfTheEffect) {
    const double with = floors();
    work_.passes.pop_back();
    EXPECT_EQ(floors(), with);
}

TEST_F(TuneWorkCost, EveryOtherPassCostsSomething) {
    const double without = floors();
    for (const char* pass : {"denoise/reuse", "resolve/upsample", "rays/reflect_query", "render/back_faces",
                             "refraction/refract", "some/new_pass"}) {
        work_.stats.scene.rays = 3000;
        work_.passes.emplace_back(pass);
        EXPECT_GT(floors(), without) << pass;
        work_.passes.pop_back();
    }
}

TEST_F(TuneWorkCost, SentinelsCostOnlyWhereRaysAreSent) {
    work_.passes = {"rays/sentinels_bvh"};
    const double everywhere = floors();
    settings_.rays.maxRoughness = 0.5f;
    EXPECT_DOUBLE_EQ(floors(), everywhere / 2);
    settings_.rays.maxRoughness = 0.3f;
    EXPECT_DOUBLE_EQ(floors(), everywhere / 2);
    settings_.rays.maxRoughness = 0.1f;
    EXPECT_EQ(floors(), 0);
}

TEST_F(TuneWorkCost, RaysOfTwoListsCountOnce) {
    work_.stats.scene.rays = 3000;
    work_.passes = {"trace/list", "rays/reflect_bvh"};
    const double once = floors();
    work_.passes = {"trace/list", "rays/reflect_bvh", "trace/list", "rays/reflect_bvh"};
    const double twice = floors();
    work_.passes = {"trace/list"};
    EXPECT_NEAR(twice - once, floors(), 1e-9); // another list, of the same rays
}

TEST_F(TuneWorkCost, MirrorsAskEveryLightAndTheDenoiserFew) {
    work_.stats.scene.rays = 3000;
    work_.passes = {"rays/reflect_bvh"};
    settings_.denoise.enabled = false;
    const double dark = floors();
    work_.lights = 10;
    const double lit = floors();
    work_.lights = 20;
    EXPECT_GT(lit, dark);
    EXPECT_NEAR(floors() - lit, lit - dark, 1e-9);
    const double mirrors = floors();
    work_.rough.add(0.5f, 0.5); // everything is rough
    settings_.denoise.enabled = true;
    settings_.rays.shadowRays = 1;
    const double few = floors();
    settings_.rays.shadowRays = 20;
    EXPECT_GT(floors(), few);
    EXPECT_GT(floors(), mirrors); // spread rays cost more
}

TEST_F(TuneWorkCost, ALayerOfGlassIsNoPassOverAllPixels) {
    const double without = floors();
    for (const char* pass : {"refraction/picture", "refraction/layer", "refraction/layers_depth"})
        work_.passes.emplace_back(pass);
    EXPECT_GT(floors(), without);
    EXPECT_LT(floors(), without + 1);
}

TEST_F(TuneWorkCost, RaysCostTheSameWithEitherBackEnd) {
    work_.stats.scene.rays = 3000;
    work_.passes = {"rays/reflect_query"};
    const double query = floors();
    work_.passes = {"rays/reflect_bvh"};
    EXPECT_EQ(floors(), query);
    settings_.reuse.samples = 0;
    work_.passes = {"denoise/reuse"};
    const double alone = floors();
    settings_.reuse.samples = 8;
    EXPECT_GT(floors(), alone * 3); // half of the pixels are rough here
}

} // namespace tune_work_cost_test
} // namespace glint::tune
