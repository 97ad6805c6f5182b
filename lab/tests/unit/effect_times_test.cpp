// Times of many frames: what counts as the effect, and the multiple of the floor.
#include "lab/measure/bench/effect_times.hpp"

#include <gtest/gtest.h>

namespace glint::measure {
namespace effect_times_test {

render::FrameTimes frame(double floor, double trace) {
    return {1,
            {{"render/surface", 50}, {"measure/floor", floor}},
            {{"prepare/dfg", 9},
             {"prepare/pyramid", 1},
             {"prepare/pyramid", 2},
             {"trace/linear", trace},
             {"composite/statistics", 7}}};
}

TEST(EffectTimes, SumsTheEffectsOwnPassesAndLeavesOutCountingAndTables) {
    EffectTimes times;
    times.add(frame(2, 7));
    EXPECT_EQ(times.total().median, 10);
    EXPECT_EQ(times.floor().median, 2);
    EXPECT_EQ(times.floorMultiple(), 5);
    ASSERT_EQ(times.passes().size(), 4u);
    EXPECT_EQ(times.passes()[1].name, "prepare/pyramid");
    EXPECT_EQ(times.passes()[1].ms.median, 3); // twice in a frame
}

TEST(EffectTimes, TheFloorOfFramesWithoutTheEffectCountsToo) {
    EffectTimes times;
    times.add(frame(10, 9));
    render::FrameTimes off = frame(2, 0);
    off.effectPasses.clear();
    times.addFloor(off);
    times.addFloor(off);
    EXPECT_EQ(times.frames(), 1u);
    EXPECT_EQ(times.floor().median, 2);
    EXPECT_EQ(times.floorMultiple(), 6);
    EXPECT_EQ(EffectTimes().floorMultiple(), 0);
}

TEST(EffectTimes, WhatTheHostDrawsForTheEffectCounts) {
    EffectTimes times;
    times.add(frame(2, 7));
    render::FrameTimes drawn = frame(2, 7);
    drawn.hostPasses.emplace_back("render/back_faces", 4);
    times.addDrawn(drawn);
    EXPECT_EQ(times.total().median, 14);
    EXPECT_EQ(times.floorMultiple(), 7);
    EXPECT_EQ(times.passes().front().name, "render/back_faces");
}

TEST(EffectTimes, SpreadOfFewAndNoValues) {
    EXPECT_EQ(Spread::of({}).median, 0);
    EXPECT_EQ(Spread::of({3}).p95, 3);
    EXPECT_EQ(Spread::of({5, 1, 3}).median, 3);
    EXPECT_EQ(Spread::of({5, 1, 3}).p95, 5);
}

} // namespace effect_times_test
} // namespace glint::measure
