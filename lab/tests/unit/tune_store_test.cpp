// The state file of a search: figures to the bit, and nothing of another search.
#include "lab/tune/evaluation_store.hpp"

#include "base/file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace glint::tune {
namespace tune_store_test {

using test::must;
using testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();

class TuneStore : public testing::Test {
protected:
    test::TempFolder folder_;
    std::string path_ = folder_ + "state.json";
};

TEST_F(TuneStore, FiguresComeBackToTheBit) {
    EvaluationStore written("request", Settings());
    Settings other;
    other.hiz.minLevel = 2;
    const Evaluation evaluation = {combine({{"a", {1.0 / 3, 0.1}}, {"b", {2.0 / 7, 1e-3 / 3}}}),
                                   {{"a", {1.0 / 3, 0.1}}, {"b", {2.0 / 7, 1e-3 / 3}}},
                                   0};
    written.add(other, ViewSet::Search, evaluation);
    written.add(other, ViewSet::Held, {combine({{"a", {2, kInf}}}), {{"a", {2, kInf}}}, 0});
    written.add(Settings(), ViewSet::Search, {{kInf, kInf}, {}, 100.0 / 3});
    written.addTiming(other, {12.0 / 7, 1.0 / 9});
    must(written.save(path_));

    EvaluationStore read("request", Settings());
    must(read.load(path_));
    EXPECT_EQ(read.size(), 3u);
    const Evaluation* const found = read.find(other, ViewSet::Search);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->figures, evaluation.figures);
    ASSERT_EQ(found->views.size(), 2u);
    EXPECT_EQ(found->views[1].figures, evaluation.views[1].figures);
    EXPECT_EQ(read.find(other, ViewSet::Held)->figures.error, kInf);
    EXPECT_TRUE(read.find(Settings(), ViewSet::Search)->views.empty()); // given up
    EXPECT_EQ(read.find(Settings(), ViewSet::Search)->limit, 100.0 / 3);
    EXPECT_EQ(read.find(Settings(), ViewSet::Held), nullptr);
    ASSERT_NE(read.findTiming(other), nullptr);
    EXPECT_EQ(read.findTiming(other)->floors, 12.0 / 7);
    EXPECT_EQ(read.findTiming(Settings()), nullptr);
}

TEST_F(TuneStore, AnotherSearchsStateIsRefused) {
    must(EvaluationStore("one", Settings()).save(path_));
    EXPECT_THAT(EvaluationStore("two", Settings()).load(path_).error().message, HasSubstr("other scenes"));
}

TEST_F(TuneStore, WhatIsNoStateIsRefused) {
    for (const char* text : {"", "{}", "[1]", "nonsense", R"({"format": "glint tune 1"})", R"({"format": 7})",
                             R"({"format": "glint tune 1", "request": "r", "evaluations": [{"set": "held"}]})",
                             R"({"format": "glint tune 1", "request": "r", "evaluations": 3, "timings": []})"}) {
        must(writeFile(path_, text));
        EvaluationStore store("r", Settings());
        const auto loaded = store.load(path_);
        ASSERT_FALSE(loaded.ok()) << text;
        EXPECT_EQ(loaded.error().code, ErrorCode::InvalidInput);
        EXPECT_EQ(store.size(), 0u);
    }
}

TEST(TuneFigures, ViewsCountByTheirRelativeErrors) {
    const Figures one = combine({{"a", {1, 0.04}}, {"b", {3, 0.01}}});
    EXPECT_DOUBLE_EQ(one.cost, 2);
    EXPECT_NEAR(one.error, 0.02, 1e-12);
    // Half of the error in either view is the same gain.
    EXPECT_NEAR(combine({{"a", {1, 0.02}}, {"b", {3, 0.01}}}).error,
                combine({{"a", {1, 0.04}}, {"b", {3, 0.005}}}).error, 1e-12);
}

} // namespace tune_store_test
} // namespace glint::tune
