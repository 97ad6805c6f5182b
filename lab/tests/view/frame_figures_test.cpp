#include "lab/view/frame_figures.hpp"
#include "lab/view/frame_pace.hpp"
#include "lab/view/time_history.hpp"

#include <gtest/gtest.h>

namespace glint::view {
namespace frame_figures_test {

TEST(FrameFigures, SayWhatTheStatsSay) {
    render::FrameTimes times;
    times.wallMs = 12;
    times.hostPasses = {{"render/surface", 3}, {"render/background", 1}};
    times.effectPasses = {
        {"prepare/pyramid", 0.5}, {"trace/classify", 0.25}, {"trace/hiz", 2}, {"composite/composite", 1}};
    const FrameFigures figures = frameFigures(times, 20);
    EXPECT_DOUBLE_EQ(figures.computeMs, 2.25);
    EXPECT_DOUBLE_EQ(figures.renderMs, 4);
    EXPECT_DOUBLE_EQ(figures.totalMs, 7.75); // "gpuMs" of --stats
    EXPECT_DOUBLE_EQ(figures.cpuMs, 12.25);
    EXPECT_DOUBLE_EQ(figures.load(figures.renderMs), 0.2);
    EXPECT_DOUBLE_EQ(frameFigures(times, 0).intervalMs, 12); // a single frame
    EXPECT_DOUBLE_EQ(FrameFigures().load(3), 0);
}

TEST(RecentTimes, AreReadAsMediansOfTheLastFrames) {
    RecentTimes recent;
    EXPECT_EQ(recent.figures().totalMs, 0);
    for (const double ms : {1.0, 9.0, 2.0, 3.0, 100.0}) {
        render::FrameTimes times;
        times.wallMs = 10 * ms;
        times.hostPasses = {{"render/surface", ms}};
        times.effectPasses = {{"trace/hiz", 2 * ms}};
        if (ms > 5)
            times.effectPasses.emplace_back("rays/now_and_then", 1.0); // not in the last frame's neighbours
        recent.add(times, 20 * ms);
    }
    EXPECT_DOUBLE_EQ(recent.figures().renderMs, 3);
    EXPECT_DOUBLE_EQ(recent.figures().computeMs, 6);
    EXPECT_DOUBLE_EQ(recent.figures().totalMs, 10);
    EXPECT_DOUBLE_EQ(recent.figures().intervalMs, 60);
    for (size_t i = 0; i < RecentTimes::kFrames; ++i)
        recent.add({}, 7);
    EXPECT_DOUBLE_EQ(recent.figures().intervalMs, 7);
}

TEST(FramePace, CoarseWhileMovingWholeWhenStill) {
    FramePace pace;
    EXPECT_EQ(pace.divisor(0), 1u);
    pace.rendered(1, 4 * FramePace::kLongestFrame);
    EXPECT_EQ(pace.divisor(0), 1u); // nothing moves
    pace.moved(1);
    EXPECT_EQ(pace.divisor(1.01), 2u);
    pace.rendered(2, 500); // no reason to go even coarser: only whole frames tell
    EXPECT_EQ(pace.divisor(1.01), 2u);
    EXPECT_EQ(pace.divisor(1.01 + FramePace::kStillSeconds), 1u);
    pace.rendered(1, 1e6);
    EXPECT_EQ(pace.divisor(1.01), FramePace::kCoarsest);
    pace.rendered(1, 1);
    EXPECT_EQ(pace.divisor(1.01), 1u); // a fast device renders all pixels at all times
}

TEST(TimeHistory, KeepsTheNewestFrames) {
    TimeHistory history;
    for (size_t i = 0; i < TimeHistory::kFrames + 10; ++i)
        history.add({{"trace/hiz", static_cast<double>(i)}});
    EXPECT_EQ(history.frames(), TimeHistory::kFrames);
    EXPECT_DOUBLE_EQ(history.frame(0).front().second, 10);
    EXPECT_EQ(history.passes(), std::vector<std::string>{"trace/hiz"});
}

} // namespace frame_figures_test
} // namespace glint::view
