// The settings as the command line sees them: two lists as one, preset < file < --set, and the page that shows them.
#include "lab/job/program_settings.hpp"

#include "base/file.hpp"
#include "base/settings/settings_docs.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace glint::render {
namespace program_settings_test {

class ProgramSettingsTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(writeFile(file_, R"({"screen.step": 4, "display": {"exposure": 1}})").ok()); }

    static std::string errorOf(const SettingsRequest& request) {
        auto loaded = loadSettings(request);
        return loaded.ok() ? "" : loaded.error().message;
    }

    const test::TempFolder temp_;
    const std::string file_ = temp_ + "settings.json";
};

TEST_F(ProgramSettingsTest, SceneThenPresetThenFileThenSet) {
    const auto loaded = loadSettings(
        {{"hiz.maxIterations=5", "screen.selfCollisionSkip=2", "screen.resolutionScale=0.9", "screen.step=9"},
         "fast",
         file_,
         {"display.exposure=2", "display.exposure=3"}});
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_EQ(loaded->reflections.hiz.maxIterations, 64);
    EXPECT_EQ(loaded->reflections.screen.resolutionScale, 0.5f);
    EXPECT_EQ(loaded->reflections.screen.step, 4);
    EXPECT_EQ(loaded->reflections.screen.selfCollisionSkip, 2);
    EXPECT_EQ(loaded->render.display.exposure, 3);
    EXPECT_EQ(loaded->preset, "fast");
}

TEST_F(ProgramSettingsTest, BareAliasesFollowThePreset) {
    EXPECT_EQ(errorOf({{}, "babylon", "", {"thickness=0.25"}}), "");
    EXPECT_EQ(errorOf({{}, "", "", {"thickness=0.25"}}),
              "--set thickness=0.25: 'thickness' is a name in several systems: "
              "write 'babylon:thickness' or 'compute-ssr:thickness'");
}

TEST_F(ProgramSettingsTest, SamplesUnderRayQueryAreRays) {
    const auto loaded = loadSettings({{}, "ray-query", "", {"samples=4"}});
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_EQ(loaded->reflections.rays.samples, 4);
    EXPECT_EQ(loaded->render.display.antialias, Antialias::Auto);
    EXPECT_EQ(errorOf({{}, "", "", {"samples=4"}}), "--set samples=4: 'samples' is a name in several systems: write "
                                                    "'babylon:samples' or 'ray-query:samples'");
}

TEST_F(ProgramSettingsTest, NumbersOfOtherSystemsPickAChoice) {
    const auto antialias = [](const std::string& assignment) {
        const auto loaded = loadSettings({{}, "babylon", "", {"display.antialias=fxaa", assignment}});
        EXPECT_TRUE(loaded.ok()) << loaded.error().message;
        return loaded->render.display.antialias;
    };
    EXPECT_EQ(antialias("samples=1"), Antialias::None);
    EXPECT_EQ(antialias("samples=4"), Antialias::Msaa4);
    EXPECT_EQ(antialias("babylon:samples=4"), Antialias::Msaa4);
    EXPECT_EQ(
        errorOf({{}, "", "", {"babylon:samples=3"}}),
        "--set babylon:samples=3: babylon:samples: expected 1, 4, auto, none, fxaa, msaa4 or accumulate, got '3'");
    const std::string page = settingsPage();
    EXPECT_NE(page.find("`babylon:samples` (1: none, 4: msaa4)"), page.npos);
}

TEST_F(ProgramSettingsTest, ErrorsSayWhere) {
    EXPECT_EQ(errorOf({{}, "", "", {"screen.step"}}), "--set screen.step: expected KEY=VALUE");
    EXPECT_EQ(errorOf({{}, "", "", {"display.tonmap=agx"}}),
              "--set display.tonmap=agx: unknown setting 'display.tonmap'; did you mean 'display.tonemap'?");
    EXPECT_EQ(errorOf({{}, "", "/no/such/file.json", {}}), "/no/such/file.json: No such file or directory");
    EXPECT_EQ(errorOf({{}, "", testing::TempDir(), {}}), testing::TempDir() + ": Is a directory");
    EXPECT_EQ(errorOf({{}, "slow", "", {}}).substr(0, 21), "unknown preset 'slow'");
}

TEST_F(ProgramSettingsTest, JsonHoldsEverySettingAndReadsBack) {
    const auto loaded = loadSettings({{}, "babylon", "", {"display.tonemap=agx", "analyticSky.turbidity=2.5"}});
    ASSERT_TRUE(loaded.ok());
    ASSERT_TRUE(writeFile(file_, settingsJson(*loaded)).ok());
    const auto again = loadSettings({{}, "", file_, {}});
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(settingsJson(*again), settingsJson(*loaded));
    EXPECT_EQ(again->render.display.tonemap, Tonemap::Agx);
}

TEST_F(ProgramSettingsTest, TheTablesDoNotCollide) {
    std::set<std::string> keys;
    for (const auto& table : allSettings()) {
        for (const SettingInfo& info : table)
            EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    }
    RenderSettings defaults;
    const SettingsTarget target{renderSettingsTable(), &defaults};
    EXPECT_TRUE(validateSettings({&target, 1}).ok());
}

TEST_F(ProgramSettingsTest, TheTableAsJsonNamesEverySetting) {
    const auto json = nlohmann::json::parse(settingsTableJson(allSettings()));
    ASSERT_EQ(json.size(), settingsTable().size() + renderSettingsTable().size());
    const auto& borderWidth = *std::ranges::find(json, "fade.borderWidth", [](const auto& s) { return s["key"]; });
    EXPECT_EQ(borderWidth["default"], 0.05);
    EXPECT_EQ(borderWidth["range"]["max"], 0.5);
    EXPECT_EQ(borderWidth["aliases"][0]["name"], "hdrp:screenWeightDistance");
}

TEST_F(ProgramSettingsTest, TheCommittedPageIsTheGeneratedOne) {
    const auto page = readFile(GLINT_SOURCE_DIR "/docs/settings.md", 1 << 20);
    ASSERT_TRUE(page.ok()) << page.error().message;
    EXPECT_EQ(*page, settingsPage()) << "run: scripts/glint settings --markdown > docs/settings.md";
}

TEST(SettingsDocs, TransformsAreSpeltOut) {
    const std::string page = settingsPage();
    EXPECT_NE(page.find("`hdrp:minSmoothness` (1-x)"), page.npos);
    EXPECT_NE(page.find("`babylon:attenuateScreenBorders` (false: none, true: smooth)"), page.npos);
    EXPECT_NE(page.find("`hdrp:screenWeightDistance` (implies linear)"), page.npos);
}

} // namespace program_settings_test
} // namespace glint::render
