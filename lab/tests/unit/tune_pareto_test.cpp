// Which points a curve has, and which of them meets a target.
#include "lab/tune/pareto.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace glint::tune {
namespace tune_pareto_test {

using testing::ElementsAre;

constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(TunePareto, TheFrontHasNoDominatedPointAndMissesNone) {
    // A grid of 20 x 20 points, some of them twice: the front by its definition, pair by pair.
    std::vector<Figures> points;
    for (int i = 0; i < 400; ++i)
        points.push_back({double((i * 7919) % 101), double((i * 104729) % 97)});
    const std::vector<size_t> front = paretoFront(points);
    std::vector<bool> isIn(points.size());
    for (const size_t i : front)
        isIn[i] = true;
    for (size_t i = 0; i < points.size(); ++i) {
        bool dominated = false, repeated = false;
        for (size_t j = 0; j < points.size(); ++j) {
            dominated |= dominates(points[j], points[i]);
            repeated |= j < i && points[j] == points[i];
        }
        EXPECT_EQ(isIn[i], !dominated && !repeated) << i;
    }
    for (size_t k = 1; k < front.size(); ++k)
        EXPECT_LT(points[front[k - 1]].cost, points[front[k]].cost);
}

TEST(TunePareto, PointsThatWereGivenUpAreOnNoFront) {
    EXPECT_THAT(paretoFront(std::vector<Figures>{{kInf, kInf}, {1, std::nan("")}, {2, 3}}), ElementsAre(2));
    EXPECT_TRUE(paretoFront(std::vector<Figures>{{kInf, kInf}}).empty());
}

TEST(TunePareto, ABudgetTakesTheLeastErrorWithinIt) {
    const std::vector<Figures> points = {{1, 9}, {2, 5}, {3, 4}, {4, 1}};
    EXPECT_THAT(byPreference(points, {.mostCost = 3, .mostError = {}}), ElementsAre(2, 1, 0, 3));
    EXPECT_THAT(byPreference(points, {.mostCost = 0.5, .mostError = {}}), ElementsAre(0, 1, 2, 3)); // the nearest first
}

TEST(TunePareto, AnErrorTakesTheLeastCostWithinIt) {
    const std::vector<Figures> points = {{1, 9}, {2, 5}, {3, 4}, {4, 1}};
    EXPECT_THAT(byPreference(points, {.mostCost = {}, .mostError = 5}), ElementsAre(1, 2, 3, 0));
    EXPECT_THAT(byPreference(points, {.mostCost = {}, .mostError = 0.5}), ElementsAre(3, 2, 1, 0));
}

TEST(TunePareto, APointHoldsUpIfItIsNotWorseThanTheStartOrTheTarget) {
    const Figures start = {10, 1};
    const Target half = {.mostCost = 5, .mostError = {}};
    EXPECT_TRUE(holdsUp({5, 1}, start, half));
    EXPECT_TRUE(holdsUp({6, 0.9}, start, half)); // other views cost other sums
    EXPECT_FALSE(holdsUp({4, 1.01}, start, half));
    EXPECT_FALSE(holdsUp({10.1, 0.5}, start, half));
    EXPECT_TRUE(holdsUp({11, 0.5}, start, {.mostCost = 12, .mostError = {}}));
    EXPECT_TRUE(holdsUp({3, 1.9}, start, {.mostCost = {}, .mostError = 2}));
    EXPECT_FALSE(holdsUp({11, 0.5}, start, {.mostCost = {}, .mostError = 2}));
}

TEST(TunePareto, TheCurveGoesThroughTheChoice) {
    // The fourth is next to the second, and a little worse in both; the fifth equals it.
    const std::vector<Figures> points = {{1, 4}, {2, 2}, {4, 1}, {2.001, 2.001}, {2.001, 2.001}};
    EXPECT_EQ(paretoFront(points), (std::vector<size_t>{0, 1, 2}));
    EXPECT_EQ(paretoFrontThrough(points, 3), (std::vector<size_t>{0, 3, 2}));
    EXPECT_EQ(paretoFrontThrough(points, 4), (std::vector<size_t>{0, 4, 2}));
    EXPECT_EQ(paretoFrontThrough(points, 1), (std::vector<size_t>{0, 1, 2}));
}

} // namespace tune_pareto_test
} // namespace glint::tune
