// A curve of cost against error, read with every value checked.
#include "lab/cli/tune/curve_file.hpp"

#include "base/file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace glint::cli {
namespace curve_file_test {

using CurveFile = nlohmann::ordered_json;

CurveFile madeUpCurve() {
    return CurveFile::parse(R"({
        "glint": "0.1.0", "device": "device", "scenes": ["builtin:hall"], "size": [640, 360], "seed": 1,
        "generations": 20, "start": "balanced", "cost": {"unit": "floors"},
        "points": [
            {"settings": {"screen": {"step": 4, "smooth": true}}, "cost": 1, "error": 0.5, "held": {"error": 0.6},
             "preset": null, "chosen": false},
            {"settings": {"screen.march": "hiz"}, "cost": 2.5, "error": 0.25, "held": {"error": 0.3},
             "preset": "tuned", "chosen": true}],
        "presets": [{"name": "fast", "cost": 1.5, "error": 0.7}],
        "sensitivities": [{"setting": "screen.step", "error": -0.1, "cost": 0.2}]})");
}

class CurveFileTest : public testing::Test {
protected:
    Result<CurveFile> read(const std::function<void(CurveFile&)>& change) {
        CurveFile json = madeUpCurve();
        change(json);
        return readText(json.dump());
    }

    Result<CurveFile> readText(const std::string& text) {
        EXPECT_TRUE(writeFile(folder_ + "curve.json", text));
        return readCurve(folder_ + "curve.json");
    }

    const test::TempFolder folder_;
};

TEST_F(CurveFileTest, SettingsBecomeAssignments) {
    const CurveFile curve = test::must(read([](CurveFile&) {}));
    EXPECT_EQ(curve["unit"], "floors");
    EXPECT_EQ(curve["size"], (CurveFile{640, 360}));
    ASSERT_EQ(curve["points"].size(), 2u);
    EXPECT_EQ(curve["points"][0]["assignments"], (CurveFile{"screen.step=4", "screen.smooth=true"}));
    EXPECT_EQ(curve["points"][1]["assignments"], CurveFile::array({"screen.march=hiz"}));
    EXPECT_EQ(curve["points"][0]["heldError"], 0.6);
    EXPECT_TRUE(curve["points"][0]["preset"].is_null());
    EXPECT_EQ(curve["points"][1]["preset"], "tuned");
    EXPECT_EQ(curve["points"][1]["chosen"], true);
    EXPECT_EQ(curve["presets"][0]["name"], "fast");
    EXPECT_EQ(curve["sensitivities"][0]["error"], -0.1);
}

TEST_F(CurveFileTest, ThePointsAreMadeOfThePresetOfTheStart) {
    const CurveFile curve = test::must(read([](CurveFile& json) {
        json["start"] = "balanced+screen.step=2";
        json["startPreset"] = "balanced";
        json["startSettings"] = {{"screen.step", 2}, {"fade.border", "none"}};
    }));
    EXPECT_EQ(curve["start"], "balanced+screen.step=2");
    EXPECT_EQ(curve["preset"], "balanced");
    EXPECT_EQ(curve["points"][0]["assignments"],
              (CurveFile{"fade.border=none", "screen.step=4", "screen.smooth=true"}));
    EXPECT_EQ(curve["points"][1]["assignments"], (CurveFile{"screen.step=2", "fade.border=none", "screen.march=hiz"}));
}

TEST_F(CurveFileTest, WhatMayBeLeftOutMay) {
    const CurveFile curve = test::must(read([](CurveFile& json) {
        json.erase("presets");
        json.erase("sensitivities");
        json["points"][0].erase("held");
        json["device"] = {{"name", "another"}, {"driver", "1"}};
    }));
    EXPECT_TRUE(curve["points"][0]["heldError"].is_null());
    EXPECT_TRUE(curve["presets"].empty());
    EXPECT_EQ(curve["preset"], "balanced");
    EXPECT_EQ(curve["device"], "another");
}

TEST_F(CurveFileTest, BadValuesAreOneLine) {
    const std::pair<std::function<void(CurveFile&)>, std::string_view> cases[] = {
        {[](CurveFile& json) { json = 3; }, "this is no JSON object"},
        {[](CurveFile& json) { json.erase("points"); }, "points is no list of 1 to 10000"},
        {[](CurveFile& json) { json["points"] = CurveFile::array(); }, "points is no list"},
        {[](CurveFile& json) { json["points"][1] = 7; }, "points[1].settings is no object"},
        {[](CurveFile& json) { json["points"][1]["cost"] = "2"; }, "points[1].cost is no number"},
        {[](CurveFile& json) { json["points"][1]["cost"] = 0.5; }, "points[1].cost is below the one before"},
        {[](CurveFile& json) { json["points"][0]["error"] = -1; }, "points[0].error is below 0"},
        {[](CurveFile& json) { json["points"][0]["held"] = 4; }, "points[0].held.error is no number"},
        {[](CurveFile& json) { json["points"][0]["chosen"] = "yes"; }, "points[0].chosen is neither"},
        {[](CurveFile& json) {
             json["points"][0]["settings"]["screen"] = {{"step", nullptr}};
         },
         "points[0].settings.screen.step is no number, text"},
        {[](CurveFile& json) {
             json["points"][0]["settings"] = {{"a", {{"b", {{"c", {{"d", {{"e", 1}}}}}}}}}};
         },
         "is no object of settings"},
        {[](CurveFile& json) { json["size"] = {640}; }, "size is no list of 2"},
        {[](CurveFile& json) {
             json["size"] = {1, 2, 3};
         },
         "size is no [width, height]"},
        {[](CurveFile& json) { json["cost"] = "floors"; }, "cost.unit is no text"},
        {[](CurveFile& json) { json["startPreset"] = 7; }, "startPreset is no text"},
        {[](CurveFile& json) { json["startSettings"] = "all"; }, "startSettings is no object of settings"},
        {[](CurveFile& json) { json["presets"][0].erase("name"); }, "presets[0].name is no text"},
        {[](CurveFile& json) { json["sensitivities"] = "none"; }, "sensitivities is no list"},
    };
    for (const auto& [change, part] : cases) {
        const Result<CurveFile> curve = read(change);
        ASSERT_FALSE(curve) << part;
        EXPECT_EQ(curve.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(curve.error().message.find(part), std::string::npos) << curve.error().message;
        EXPECT_TRUE(curve.error().message.starts_with("--curve ")) << curve.error().message;
    }
    EXPECT_FALSE(readText("{\"points\": [1e999]"));
    EXPECT_EQ(readCurve(folder_ + "none.json").error().code, ErrorCode::NotFound);
}

} // namespace curve_file_test
} // namespace glint::cli
