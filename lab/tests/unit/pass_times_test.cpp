// Medians of pass times, in the order of the frame.
#include "lab/session/pass_times.hpp"

#include <gtest/gtest.h>

namespace glint::render {
namespace pass_times_test {

using Times = std::vector<std::pair<std::string, double>>;

TEST(PassTimes, AreMediansInTheOrderInWhichPassesRun) {
    PassTimes times;
    for (const double milliseconds : {5.0, 1.0, 100.0}) {
        times.add("trace/hiz", milliseconds);
        times.add("composite", milliseconds / 2);
    }
    EXPECT_EQ(times.medians(), (Times{{"trace/hiz", 5}, {"composite", 2.5}}));
    times.add("a pass that came later", 3);
    times.add("trace/hiz", 6);
    EXPECT_EQ(times.medians(), (Times{{"trace/hiz", 6}, {"composite", 2.5}, {"a pass that came later", 3}}));
    times.clear();
    EXPECT_EQ(times.medians(), Times());
}

TEST(PassTimes, ForgetTheOlderHalfOfManyFrames) {
    PassTimes times;
    for (size_t i = 0; i < PassTimes::kMostFrames; ++i)
        times.add("pass", 1);
    for (size_t i = 0; i < PassTimes::kMostFrames / 2 + 1; ++i)
        times.add("pass", 9);
    EXPECT_EQ(times.medians(), (Times{{"pass", 9}}));
}

} // namespace pass_times_test
} // namespace glint::render
