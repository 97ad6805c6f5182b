// measure/bench_check and `glint bench --check`'s reader: what counts as slower, and files that are no benchmark's.
#include "lab/cli/bench/bench_base.hpp"
#include "lab/cli/bench/bench_output.hpp"

#include <gtest/gtest.h>

namespace glint::test {
namespace bench_check_test {

using measure::BenchBase;
using measure::BenchFigure;
using measure::CheckedFigure;

BenchFigure figure(std::string config, double floors, double lookups) {
    return {"builtin:hall", {640, 360}, {}, std::move(config), floors, lookups};
}

BenchBase base() {
    return {"device", 2, 5, {figure("balanced", 20, 22.5), figure("fast", 10, 20)}};
}

std::vector<CheckedFigure> check(const std::vector<BenchFigure>& now, std::string_view device = "device") {
    auto checked = measure::checkFigures(base(), now, device, {0.5, 0.01});
    EXPECT_TRUE(checked.ok()) << checked.error().message;
    return *checked;
}

TEST(BenchCheck, WhatHasNotGrownBeyondTheToleranceIsGood) {
    for (const CheckedFigure& checked : check({figure("balanced", 29.9, 22.6), figure("fast", 3, 1)}))
        EXPECT_TRUE(checked.good());
}

TEST(BenchCheck, MoreFloorsAreSlowerAndMoreLookupsAreMore) {
    const auto checked = check({figure("balanced", 30.1, 22.5), figure("fast", 10, 20.3)});
    EXPECT_TRUE(checked[0].slower);
    EXPECT_FALSE(checked[0].moreLookups);
    EXPECT_FALSE(checked[1].slower);
    EXPECT_TRUE(checked[1].moreLookups);
}

TEST(BenchCheck, AnotherDevicesFloorsAreNotCompared) {
    const auto checked = check({figure("balanced", 500, 22.5), figure("fast", 10, 25)}, "another");
    EXPECT_FALSE(checked[0].slower);
    EXPECT_TRUE(checked[1].moreLookups);
}

TEST(BenchCheck, WhatWasNotMeasuredIsAnError) {
    const auto checked = measure::checkFigures(base(), {figure("balanced", 20, 22)}, "device", {});
    ASSERT_FALSE(checked.ok());
    EXPECT_NE(checked.error().message.find("builtin:hall at 640x360, fast"), std::string::npos);
}

TEST(BenchCheck, OfTwoMeasurementsTheFasterCounts) {
    std::vector<BenchFigure> best = {figure("balanced", 40, 22), figure("fast", 9, 20)};
    measure::keepFaster(best, {figure("fast", 12, 20), figure("balanced", 21, 22)});
    EXPECT_EQ(best[0].floors, 21);
    EXPECT_EQ(best[1].floors, 9);
}

TEST(BenchCheck, ReadsWhatTheBenchmarkWrites) {
    measure::BenchResult result;
    result.device = "device";
    result.plan.frames = 5;
    result.plan.warmUp = 2;
    result.configs = {"balanced", "fast"};
    measure::BenchPoint point;
    point.scene = "builtin:hall";
    point.plan.width = 640;
    point.plan.height = 360;
    point.figures.resize(2);
    point.figures[0].stats.lookupsPerRay = 22.5;
    result.points = {point, point};
    result.points[1].plan.share = 0.25f;
    const auto read = cli::readBenchBase(cli::benchJson(result), "base.json");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->device, "device");
    EXPECT_EQ(read->frames, 5U);
    EXPECT_EQ(read->warmUp, 2U);
    ASSERT_EQ(read->figures.size(), 4U);
    EXPECT_EQ(read->figures[0].lookups, 22.5);
    EXPECT_EQ(read->figures[1].config, "fast");
    EXPECT_FALSE(read->figures[1].share);
    EXPECT_EQ(read->figures[2].share, 0.25f);
    EXPECT_EQ(read->figures[0].size, glm::uvec2(640, 360));
}

TEST(BenchCheck, WhatIsNoBenchmarkIsAnErrorThatSaysWhere) {
    const std::pair<const char*, const char*> bad[] = {
        {"", "not JSON"},
        {"[]", "device: name"},
        {R"({"device": {"name": "x"}})", "warmUp"},
        {R"({"device": {"name": "x"}, "warmUp": 1.5, "frames": 1})", "warmUp: expected a whole number"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 0})", "frames"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 1, "points": []})", "points"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 1, "points": [3]})", "points[0]: scene"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 1, "points": [{"scene": "s", "width": -1}]})", "width"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 1,
             "points": [{"scene": "s", "width": 1, "height": 1, "share": 7, "configs": []}]})",
         "share"},
        {R"({"device": {"name": "x"}, "warmUp": 1, "frames": 1,
             "points": [{"scene": "s", "width": 1, "height": 1, "configs": [{"name": "c", "floorMultiple": "1"}]}]})",
         "configs[0]: floorMultiple"},
    };
    for (const auto& [text, expected] : bad) {
        const auto read = cli::readBenchBase(text, "base.json");
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_NE(read.error().message.find(expected), std::string::npos) << text << ": " << read.error().message;
        EXPECT_NE(read.error().message.find("base.json"), std::string::npos);
    }
}

} // namespace bench_check_test
} // namespace glint::test
