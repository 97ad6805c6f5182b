// What has become better or worse, with figures whose answer is worked out by hand.
#include "lab/measure/figures/figure_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::measure {
namespace figure_change_test {

Figure figure(FigureKind kind, std::vector<double> values, const std::string& name = "figure") {
    const Estimate estimate = values.size() > 1 ? Estimate::of(values) : Estimate{values.front(), 0, 0};
    return {"scene", "config", name, kind, estimate};
}

TEST(FigureChange, TwoSeedsHaveHalfTheirDifferenceAsError) {
    const Estimate estimate = Estimate::of(std::vector{1.0, 1.2});
    EXPECT_DOUBLE_EQ(estimate.value, 1.1);
    EXPECT_NEAR(estimate.standardError, 0.1, 1e-12);
    EXPECT_EQ(estimate.freedom, 1);
    const Estimate four = Estimate::of(std::vector{1.0, 2.0, 3.0, 4.0}); // variance 5/3, of the mean 5/12
    EXPECT_NEAR(four.standardError, std::sqrt(5.0 / 12), 1e-12);
    EXPECT_EQ(four.freedom, 3);
    EXPECT_EQ(Estimate::of(std::vector{0.1, 0.1, 0.1}).standardError, 0);
}

TEST(FigureChange, TheFactorIsStudents) {
    EXPECT_DOUBLE_EQ(studentFactor(1), 12.706);
    EXPECT_DOUBLE_EQ(studentFactor(2.9), 4.303);
    EXPECT_DOUBLE_EQ(studentFactor(0.5), 12.706);
    EXPECT_DOUBLE_EQ(studentFactor(30), 2.042);
    EXPECT_NEAR(studentFactor(60), 2.000, 0.002); // tables: 2.000
    EXPECT_NEAR(studentFactor(1e9), 1.960, 0.001);
}

TEST(FigureChange, ASmallDifferenceIsNoise) {
    // Errors 0.1 and 0.1: together 0.1414 with 2 degrees of freedom, so the interval is 0.2 +- 0.6085.
    const FigureChange change = changeOf(figure(FigureKind::Error, {1.0, 1.2}), figure(FigureKind::Error, {1.2, 1.4}));
    EXPECT_EQ(change.verdict, Verdict::Noise);
    EXPECT_NEAR(change.worse, 100 * 0.2 / 1.1, 1e-9);
    EXPECT_NEAR(change.low, 100 * (0.2 - 0.60855) / 1.1, 0.01);
    EXPECT_NEAR(change.high, 100 * (0.2 + 0.60855) / 1.1, 0.01);
    EXPECT_FALSE(change.exceeds(5));
}

TEST(FigureChange, ALargeOneIsNot) {
    const Figure low = figure(FigureKind::Error, {1.0, 1.2}), high = figure(FigureKind::Error, {3.0, 3.2});
    const FigureChange worse = changeOf(low, high); // 2 +- 0.6085 of 1.1: 126 % to 237 %
    EXPECT_EQ(worse.verdict, Verdict::Worse);
    EXPECT_TRUE(worse.exceeds(126));
    EXPECT_FALSE(worse.exceeds(127)) << "the point is at 182 %, but the interval is not all above";
    EXPECT_EQ(changeOf(high, low).verdict, Verdict::Better);
    EXPECT_FALSE(changeOf(high, low).exceeds(0));
}

TEST(FigureChange, OneSideWithoutNoiseLeavesTheOthers) {
    // 0.2 +- 12.706 * 0.01
    const FigureChange change = changeOf(figure(FigureKind::Error, {1}), figure(FigureKind::Error, {1.19, 1.21}));
    EXPECT_EQ(change.verdict, Verdict::Worse);
    EXPECT_NEAR(change.low, 20 - 12.706, 1e-9);
}

TEST(FigureChange, SharesChangeInPoints) {
    const FigureChange fewer = changeOf(figure(FigureKind::Share, {0.95}), figure(FigureKind::Share, {0.90}));
    EXPECT_EQ(fewer.verdict, Verdict::Worse);
    EXPECT_NEAR(fewer.worse, 5, 1e-9);
    const FigureChange wrong = changeOf(figure(FigureKind::Wrong, {0.02}), figure(FigureKind::Wrong, {0.01}));
    EXPECT_EQ(wrong.verdict, Verdict::Better);
    EXPECT_NEAR(wrong.worse, -1, 1e-9);
}

TEST(FigureChange, FromZeroIsWithoutBound) {
    EXPECT_EQ(changeOf(figure(FigureKind::Error, {0}), figure(FigureKind::Error, {0})).verdict, Verdict::Same);
    const FigureChange change = changeOf(figure(FigureKind::Error, {0}), figure(FigureKind::Error, {1e-9}));
    EXPECT_EQ(change.verdict, Verdict::Worse);
    EXPECT_TRUE(change.exceeds(1e300));
}

TEST(FigureChange, FiguresAreMatchedByName) {
    const std::vector before = {figure(FigureKind::Error, {1}, "kept"), figure(FigureKind::Time, {1}, "time"),
                                figure(FigureKind::Error, {1}, "gone")};
    const std::vector now = {figure(FigureKind::Error, {2}, "new"), figure(FigureKind::Error, {2}, "kept"),
                             figure(FigureKind::Time, {2}, "time")};
    const FigureChanges same = compareFigures(before, now, true);
    ASSERT_EQ(same.changes.size(), 2u);
    EXPECT_EQ(same.changes[0].now.name, "kept");
    EXPECT_NEAR(same.changes[1].worse, 100, 1e-9);
    ASSERT_EQ(same.added.size(), 1u);
    EXPECT_EQ(same.added[0].name, "new");
    ASSERT_EQ(same.removed.size(), 1u);
    EXPECT_EQ(same.removed[0].name, "gone");
    const FigureChanges other = compareFigures(before, now, false);
    EXPECT_EQ(other.changes.size(), 1u);
    EXPECT_EQ(other.otherDevice, 1u);
}

} // namespace figure_change_test
} // namespace glint::measure
