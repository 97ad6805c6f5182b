// The table of costs: its file, and what a measurement may change of it.
#include "lab/tune/cost_table.hpp"

#include "base/file.hpp"
#include "lab/tune/cost_fit.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace glint::tune {
namespace tune_cost_table_test {

std::string fileText() {
    const auto text = readFile(GLINT_SOURCE_DIR "/bench/costs.json", 1 << 20);
    return text ? *text : text.error().message;
}

TEST(TuneCostTable, TheFileHasTheFormThatBenchWrites) {
    EXPECT_EQ(costsText(costTable()), fileText());
}

TEST(TuneCostTable, OtherFilesAreRefused) {
    const auto message = [](std::string_view text) {
        const auto read = readCosts(text, "a.json");
        return read ? std::string() : read.error().message;
    };
    EXPECT_NE(message("{}").find("a.json: no table of costs"), std::string::npos);
    EXPECT_NE(message("nothing").find("a.json: no table of costs"), std::string::npos);
    std::string wrong = fileText();
    wrong.replace(wrong.find("\"backFaces\""), 11, "\"backfaces\"");
    EXPECT_NE(message(wrong).find("no such unit"), std::string::npos);
    wrong = fileText();
    wrong.replace(wrong.find("\"floors\": "), 10, "\"floors\": -");
    EXPECT_NE(message(wrong).find("below 0"), std::string::npos);
}

/// The passes of docs/passes.md that frames of presets run (tests/gpu/pass_table_test.cpp).
std::vector<std::string> passesOfPresets() {
    const std::string page = test::must(readFile(GLINT_SOURCE_DIR "/docs/passes.md", 1 << 20));
    std::vector<std::string> passes;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `") || !line.ends_with(" |"))
            continue;
        const std::string runs = line.substr(line.rfind("| ", line.size() - 3) + 2);
        const bool preset = std::ranges::any_of(presetNames(), [&](std::string_view name) {
            return runs.starts_with(name) || runs.starts_with("all presets");
        });
        if (preset)
            passes.push_back(line.substr(3, line.find('`', 3) - 3));
    }
    return passes;
}

TEST(TuneCostTable, EveryPassOfAPresetHasARow) {
    const std::vector<std::string> passes = passesOfPresets();
    EXPECT_GT(passes.size(), 20u);
    for (const std::string& pass : passes)
        EXPECT_TRUE(costTable().hasRow(pass)) << pass << ": add a row to bench/costs.json";
}

class TuneCostFit : public testing::Test {
protected:
    TuneCostFit() {
        const auto unit = [](std::string_view name) { return &*std::ranges::find(costUnits(), name, &CostUnit::name); };
        table_.rows = {{"trace/hiz", unit("rays"), 1, ""},
                       {"trace/hiz", unit("lookups"), 1, ""},
                       {"trace/list", unit("traced"), 1, ""}};
    }
    void frame(double rays, double lookups, double floors) {
        samples_.push_back({"frame", {{"trace/hiz", floors}}, {rays, lookups, 1}});
    }
    CostTable table_;
    std::vector<CostSample> samples_;
};

TEST_F(TuneCostFit, FindsTheCostsThatFramesHad) {
    for (const auto& [rays, lookups] : {std::pair{0.1, 2.0}, {0.5, 5.0}, {0.4, 12.0}, {0.9, 9.0}})
        frame(rays, lookups, 3 * rays + 0.5 * lookups);
    const std::vector<FittedRow> fitted = fitCosts(table_, samples_);
    ASSERT_EQ(fitted.size(), 3u);
    EXPECT_EQ(fitted[0].kept, "");
    EXPECT_NEAR(fitted[0].floors, 3, 0.01);
    EXPECT_NEAR(fitted[1].floors, 0.5, 0.01);
    EXPECT_EQ(fitted[2].floors, 1);
    EXPECT_EQ(fitted[2].kept, "ran in 0 of 4 frames");
}

TEST_F(TuneCostFit, KeepsWhatFramesCannotTellApart) {
    for (const double rays : {0.1, 0.5, 0.4, 0.9})
        frame(rays, 20 * rays, 7 * rays);
    for (const FittedRow& row : fitCosts(table_, samples_))
        EXPECT_EQ(row.floors, 1) << row.kept;
    EXPECT_EQ(fitCosts(table_, samples_)[0].kept, "its units grow together in these frames");
}

TEST_F(TuneCostFit, KeepsRatherThanACostBelowZero) {
    for (const auto& [rays, lookups] : {std::pair{0.1, 2.0}, {0.5, 5.0}, {0.4, 12.0}, {0.9, 9.0}})
        frame(rays, lookups, 0.5 * lookups - 0.2 * rays);
    EXPECT_EQ(fitCosts(table_, samples_)[0].kept, "the fit gives a cost below 0");
    EXPECT_EQ(fitCosts(table_, samples_)[1].floors, 1);
}

TEST_F(TuneCostFit, FitsTheOthersWhereAUnitDidNotOccur) {
    for (const double lookups : {2.0, 5.0, 12.0})
        frame(0, lookups, 2 * lookups);
    const std::vector<FittedRow> fitted = fitCosts(table_, samples_);
    EXPECT_EQ(fitted[0].kept, "no frame had any rays");
    EXPECT_EQ(fitted[1].kept, "");
    EXPECT_NEAR(fitted[1].floors, 2, 0.01);
}

} // namespace tune_cost_table_test
} // namespace glint::tune
