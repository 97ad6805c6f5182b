#include "lab/view/settings_model.hpp"
#include "lab/view/ssr_keys.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace glint::view {
namespace settings_model_test {

SettingsModel makeModel(const render::SettingsRequest& request = {}) {
    return SettingsModel(request, *render::loadSettings(request));
}

double valueOf(const SettingsModel& model, std::string_view key) {
    return model.value(settingOf(key));
}

TEST(SettingsModel, KnowsWhatDiffersFromThePreset) {
    SettingsModel model = makeModel({{"environment.strength=0.5"}, "babylon", "", {"screen.step=3"}});
    EXPECT_EQ(model.changedCount(), 1u); // what suits the scene is no change
    EXPECT_TRUE(model.changed(settingOf("screen.step")));
    EXPECT_EQ(model.options(), "--preset babylon --set screen.step=3");
    model.reset(settingOf("screen.step"));
    EXPECT_EQ(model.changedCount(), 0u);
    EXPECT_EQ(valueOf(model, "screen.step"), 1);
}

TEST(SettingsModel, EveryChangeCanBeTakenBack) {
    SettingsModel model = makeModel();
    const std::string start = render::settingsJson(model.settings());
    model.set(settingOf("screen.step"), 2);
    ASSERT_TRUE(model.assign("babylon:thickness", "0.25"));
    ASSERT_TRUE(model.usePreset("hdrp"));
    model.set(settingOf("screen.step"), 7);
    const std::string end = render::settingsJson(model.settings());
    EXPECT_EQ(model.settings().preset, "hdrp");
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(model.undo());
    EXPECT_FALSE(model.undo());
    EXPECT_EQ(render::settingsJson(model.settings()), start);
    EXPECT_EQ(model.changedCount(), 0u); // the preset's baseline came back too
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(model.redo());
    EXPECT_FALSE(model.redo());
    EXPECT_EQ(render::settingsJson(model.settings()), end);
    EXPECT_EQ(model.changedCount(), 1u);
}

TEST(SettingsModel, AnotherSceneHasWhatSuitsIt) {
    SettingsModel model = makeModel({{"environment.strength=0.15"}, "babylon", "", {"screen.step=3"}});
    model.set(settingOf("environment.rotation"), 30);
    const uint64_t version = model.version();
    ASSERT_TRUE(model.suitScene({"environment.strength=0.5"}));
    EXPECT_NE(model.version(), version);
    EXPECT_EQ(valueOf(model, "environment.strength"), 0.5);
    EXPECT_EQ(model.options(), "--preset babylon --set screen.step=3 --set environment.rotation=30");
    EXPECT_TRUE(model.undo()); // back to before the rotation, not to the scene before
    EXPECT_EQ(valueOf(model, "environment.rotation"), 0);
    EXPECT_EQ(valueOf(model, "environment.strength"), 0.5);
    ASSERT_TRUE(model.usePreset("hdrp"));
    EXPECT_EQ(valueOf(model, "environment.strength"), 0.5);
    model.set(settingOf("environment.strength"), 2);
    ASSERT_TRUE(model.suitScene({})); // a scene without wishes
    EXPECT_EQ(valueOf(model, "environment.strength"), 2);
    model.reset(settingOf("environment.strength"));
    EXPECT_EQ(valueOf(model, "environment.strength"), 1);
    EXPECT_FALSE(model.suitScene({"environment.strength=no"}));
    EXPECT_EQ(model.changedCount(), 0u);
}

TEST(SettingsModel, OneDragIsOneStep) {
    SettingsModel model = makeModel();
    const SettingInfo& step = settingOf("screen.step");
    model.set(step, 2);
    model.set(step, 3, true);
    model.set(step, 4, true);
    EXPECT_TRUE(model.undo());
    EXPECT_EQ(model.value(step), 1);
    EXPECT_TRUE(model.redo());
    EXPECT_EQ(model.value(step), 4);
    model.undo();
    model.set(step, 9); // what was undone is gone
    EXPECT_FALSE(model.redo());
}

TEST(SettingsModel, ValuesStayInRange) {
    SettingsModel model = makeModel();
    for (const std::span<const SettingInfo> table : render::allSettings())
        for (const SettingInfo& info : table)
            for (const double value : {-1e30, 1e30, 0.0, 0.37, std::nan("")}) {
                model.set(info, value);
                const double held = model.value(info), slack = 1e-6 * std::abs(held); // floats round the ends
                const SettingRange& range = info.range;
                EXPECT_TRUE(range.text.empty() || (held >= range.min - slack && held <= range.max + slack))
                    << info.key << " = " << held;
            }
    render::ProgramSettings settings = model.settings();
    EXPECT_TRUE(validateSettings(settings.targets()));
}

TEST(SettingsModel, FilesComeBackToTheBit) {
    const test::TempFolder folder;
    const std::string path = folder + "mine.json";
    SettingsModel model = makeModel({{}, "babylon", "", {}});
    model.set(settingOf("screen.maxDistance"), 12.345);
    model.set(settingOf("screen.march"), 2);
    ASSERT_TRUE(model.save(path));
    SettingsModel other = makeModel();
    ASSERT_TRUE(other.load(path));
    EXPECT_EQ(render::settingsJson(other.settings()), render::settingsJson(model.settings()));
    EXPECT_TRUE(other.undo());
    ASSERT_TRUE(writeFile(path, "{\"screen\": {\"step\": \"no\"}}"));
    const auto failed = other.load(path);
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, testing::HasSubstr("mine.json:1"));
    EXPECT_EQ(other.changedCount(), 0u);
}

TEST(SettingsModel, SearchKnowsOtherSystemsNames) {
    const SettingsModel model = makeModel();
    const auto first = [&](std::string_view text) {
        const auto found = model.search(text);
        return found.empty() ? std::string("nothing") : found.front()->key;
    };
    EXPECT_EQ(first("maxDistance"), "screen.maxDistance");
    EXPECT_EQ(first("useFresnel"), "reflect.fresnel");
    EXPECT_EQ(first("hdrp:rayMaxIterations"), "hiz.maxIterations");
    EXPECT_EQ(first("zzzz"), "nothing");
    size_t all = 0;
    for (const auto& table : render::allSettings())
        all += table.size();
    EXPECT_EQ(model.search("").size(), all);
}

TEST(SsrKeys, VGoesRoundComputeSsrsViews) {
    std::string view = "composite";
    std::string round;
    for (int i = 0; i < 5; ++i)
        round += (view = nextView(view)) + " ";
    EXPECT_EQ(round, "scene reflection normal depth composite ");
    EXPECT_EQ(nextView("lookups"), "composite");
}

TEST(SsrKeys, EachPairGoesUpAndComesBack) {
    for (const SsrKey& key : kSsrKeys) {
        SettingsModel model = makeModel({{}, "compute-ssr", "", {}});
        const double before = valueOf(model, key.setting);
        ASSERT_TRUE(pressSsrKey(key.more, model)) << key.name;
        EXPECT_GT(valueOf(model, key.setting), before) << key.name;
        ASSERT_TRUE(pressSsrKey(key.less, model));
        EXPECT_NEAR(valueOf(model, key.setting), before, 1e-5) << key.name;
        for (int i = 0; i < 200; ++i)
            pressSsrKey(key.less, model);
        EXPECT_NEAR(valueOf(model, key.setting), key.min, 1e-6) << key.name;
        for (int i = 0; i < 400; ++i)
            pressSsrKey(key.more, model);
        EXPECT_NEAR(valueOf(model, key.setting), key.max, 1e-6 * key.max) << key.name;
    }
    SettingsModel model = makeModel();
    EXPECT_FALSE(pressSsrKey('V', model));
}

TEST(SsrKeys, AFactorThereAndBackLeavesTheNumberAsItWasWritten) {
    for (const char* value : {"0.2", "12.8", "0.7", "20", "3.3"})
        for (const std::string_view keys : {"34", "43", "3344"}) {
            SettingsModel model = makeModel();
            ASSERT_TRUE(model.assign("screen.maxDistance", value).ok());
            for (const char key : keys)
                pressSsrKey(key, model);
            const double distance = valueOf(model, "screen.maxDistance");
            EXPECT_EQ(settingText(settingOf("screen.maxDistance"), distance), value) << keys;
        }
}

TEST(SsrKeys, StepsStayOnTheirGrid) {
    SettingsModel model = makeModel();
    for (int i = 0; i < 7; ++i)
        pressSsrKey('2', model);
    EXPECT_EQ(settingText(settingOf("reflect.strength"), valueOf(model, "reflect.strength")), "1.7");
}

} // namespace settings_model_test
} // namespace glint::view
