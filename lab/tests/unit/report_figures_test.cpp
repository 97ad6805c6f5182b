// The figures of a report against those of an earlier one: made-up values whose verdict is known.
#include "lab/cli/report/report_figures.hpp"
#include "lab/cli/report/report_json.hpp"

#include "base/file.hpp"
#include "lab/tests/unit/report_fixture.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string_view>

namespace glint::cli {
namespace report_figures_test {

using measure::Verdict;

/// Writes a report as an earlier one, after `change`, and compares the made-up scene with it.
class AgainstTest : public testing::Test {
protected:
    Result<ReportChanges> against(double errorNow, const std::function<void(nlohmann::ordered_json&)>& change = {}) {
        Report earlier;
        earlier.options = options_;
        earlier.scenes.push_back(test::madeUpScene("scene"));
        nlohmann::ordered_json json = reportJson(earlier);
        if (change)
            change(json);
        return againstText(json.dump(), errorNow);
    }

    Result<ReportChanges> againstText(const std::string& text, double errorNow = 0.5) {
        EXPECT_TRUE(writeFile(folder_ + "old.json", text));
        GLINT_TRY(earlier, readEarlierReport(folder_ + "old.json"));
        std::vector<ReportScene> now;
        now.push_back(test::madeUpScene("scene", errorNow));
        GLINT_TRY(changes, changesSince(earlier, now));
        changes.threshold = 5;
        changes.timeThreshold = 20;
        return changes;
    }

    static const measure::FigureChange& find(const ReportChanges& changes, std::string_view name) {
        return *std::ranges::find_if(changes.figures.changes,
                                     [&](const auto& change) { return change.now.name == name; });
    }

    const test::TempFolder folder_;
    const nlohmann::ordered_json options_ = {{"--env", "sky"}, {"--reference-frames", "1"}, {"--planar", "none"}};
};

TEST_F(AgainstTest, TheSameIsTheSame) {
    const ReportChanges changes = test::must(against(0.5));
    ASSERT_GT(changes.figures.changes.size(), 5u);
    for (const measure::FigureChange& change : changes.figures.changes) {
        EXPECT_TRUE(change.verdict == Verdict::Same || change.verdict == Verdict::Noise) << change.now.name;
        EXPECT_EQ(change.worse, 0) << change.now.name;
        EXPECT_FALSE(changes.fails(change));
    }
    EXPECT_EQ(changes.device, "device <b>");
}

TEST_F(AgainstTest, NoiseIsToldFromAChange) {
    // Before 0.5 and 0.55: 0.525 with an error of 0.025. After 0.52 and 0.572: within that.
    EXPECT_EQ(find(test::must(against(0.52)), "error.relativeMse.all").verdict, Verdict::Noise);
    // After 5 and 5.5: 5.25 with 0.25. The change of 4.725 has an interval of +- 12.706 * sqrt(0.25^2 + 0.025^2)
    // = 3.19.
    const ReportChanges changes = test::must(against(5));
    const measure::FigureChange& worse = find(changes, "error.relativeMse.all");
    EXPECT_EQ(worse.verdict, Verdict::Worse);
    EXPECT_NEAR(worse.worse, 900, 1e-6);
    EXPECT_NEAR(worse.low, 100 * (4.725 - 12.706 * 0.251247) / 0.525, 0.1);
    EXPECT_TRUE(changes.fails(worse));
    const std::string text = changesText(changes);
    EXPECT_NE(text.find("0 better, 2 worse"), text.npos) << text; // of both configs
    EXPECT_NE(text.find("error.relativeMse.all 0.525 -> 5.25, +900.00 %: more than the threshold"), text.npos) << text;
}

TEST_F(AgainstTest, ARecallThatFellFails) {
    const auto higher = [](nlohmann::ordered_json& json) {
        for (auto& figure : json["figures"])
            if (figure["name"] == "hits.recall.all" && figure["value"] == 0.5)
                figure["value"] = 0.6;
    };
    const ReportChanges changes = test::must(against(0.5, higher));
    const auto recall = std::ranges::find_if(changes.figures.changes, [](const auto& change) {
        return change.now.name == "hits.recall.all" && change.verdict == Verdict::Worse;
    });
    ASSERT_NE(recall, changes.figures.changes.end());
    EXPECT_NEAR(recall->worse, 10, 1e-9);
    EXPECT_TRUE(changes.fails(*recall));
    const nlohmann::ordered_json json = changesJson(changes);
    EXPECT_TRUE(std::ranges::any_of(json["changes"], [](const auto& change) {
        return change["name"] == "hits.recall.all" && change["fails"] == true && change["verdict"] == "worse";
    }));
}

TEST_F(AgainstTest, UnlikeReportsAreNotCompared) {
    ASSERT_TRUE(against(0.5));
    const EarlierReport earlier = test::must(readEarlierReport(folder_ + "old.json"));
    EXPECT_TRUE(checkSameOptions(earlier, options_));
    const Result<void> differs = checkSameOptions(
        earlier, {{"--env", ""}, {"--reference-frames", "4"}, {"--planar", "none"}, {"--motion-size", "9x9"}});
    ASSERT_FALSE(differs);
    EXPECT_EQ(differs.error().code, ErrorCode::InvalidInput);
    const std::string& message = differs.error().message;
    for (const std::string_view part :
         {"old.json: it was measured with", "--env sky (now no --env)",
          "--reference-frames 1 (now --reference-frames 4)", "no --motion-size (now --motion-size 9x9)"})
        EXPECT_NE(message.find(part), message.npos) << message;
    EXPECT_EQ(message.find("--planar"), message.npos) << message;
}

TEST_F(AgainstTest, BadFilesAreOneLine) {
    using Json = nlohmann::ordered_json;
    const auto message = [](const Result<ReportChanges>& changes) {
        return changes ? std::string("no error") : changes.error().message;
    };
    EXPECT_NE(message(againstText("")).find("give the file that glint report --json wrote"), std::string::npos);
    EXPECT_NE(message(againstText("[1, 2]")).find("give the file"), std::string::npos);
    EXPECT_NE(message(againstText("{\"format\": 3}")).find("give the file"), std::string::npos);
    const std::pair<std::function<void(Json&)>, std::string_view> cases[] = {
        {[](Json& json) { json.erase("figures"); }, "figures is no list"},
        {[](Json& json) { json["figures"] = 7; }, "figures is no list"},
        {[](Json& json) { json.erase("options"); }, "it does not say with which options it was measured"},
        {[](Json& json) { json["options"]["--env"] = 7; }, "options is no object of texts"},
        {[](Json& json) { json["figures"][2] = 7; }, "figure 2 is no object"},
        {[](Json& json) { json["figures"][1].erase("name"); }, "figure 1: name is no text"},
        {[](Json& json) { json["figures"][1]["value"] = "5"; }, "figure 1: value is no number"},
        {[](Json& json) { json["figures"][1]["kind"] = "colour"; }, "figure 1: kind 'colour' is unknown"},
        {[](Json& json) { json["figures"][1]["standardError"] = -1; }, "figure 1: standardError -1"},
        {[](Json& json) {
             json["figures"][1]["standardError"] = 1;
             json["figures"][1]["freedom"] = 0;
         },
         "figure 1: standardError 1 with freedom 0"},
        {[](Json& json) {
             for (Json& figure : json["figures"])
                 figure["scene"] = "other";
         },
         "no figure of these scenes"},
    };
    for (const auto& [change, part] : cases) {
        const Result<ReportChanges> changes = against(0.5, change);
        ASSERT_FALSE(changes) << part;
        EXPECT_EQ(changes.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(changes.error().message.find(part), std::string::npos) << changes.error().message;
        EXPECT_TRUE(changes.error().message.starts_with("--against ")) << changes.error().message;
    }
    EXPECT_EQ(readEarlierReport(folder_ + "none.json").error().code, ErrorCode::NotFound);
}

} // namespace report_figures_test
} // namespace glint::cli
