// Settings files: both shapes, what is refused and on which line, and that a refused file changes nothing.
#include "glint/settings.hpp"

#include "base/settings/settings_target.hpp"
#include "support/must.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace glint {
namespace settings_json_test {

std::string errorOf(std::string_view text, std::string_view preset = {}) {
    Settings settings;
    const auto done = fromJson(settings, text, "my.json", preset);
    return done.ok() ? "" : done.error().message;
}

TEST(SettingsJson, TakesNestedAndFlatNamesAndAliases) {
    Settings settings;
    const auto done = fromJson(settings, R"({"description": "mine",
        "screen": {"step": 4, "smooth": false}, "fade.border": "none", "babylon:maxDistance": 20.5, "strength": 2})",
                               "my.json");
    ASSERT_TRUE(done.ok()) << done.error().message;
    EXPECT_EQ(settings.screen.step, 4);
    EXPECT_FALSE(settings.screen.smooth);
    EXPECT_EQ(settings.fade.border, FadeBorder::None_);
    EXPECT_EQ(settings.screen.maxDistance, 20.5f);
    EXPECT_EQ(settings.reflect.strength, 2);
    EXPECT_EQ(settings.screen.maxSteps, Settings{}.screen.maxSteps);
}

TEST(SettingsJson, AnEmptyObjectChangesNothing) {
    Settings settings;
    settings.screen.step = 7;
    ASSERT_TRUE(fromJson(settings, "{}", "my.json").ok());
    EXPECT_EQ(settings.screen.step, 7);
}

TEST(SettingsJson, BareAliasesFollowThePreset) {
    EXPECT_EQ(errorOf("{\n\"thickness\": 1}"), "my.json:2: 'thickness' is a name in several systems: write "
                                               "'babylon:thickness' or 'compute-ssr:thickness'");
    EXPECT_EQ(errorOf(R"({"thickness": 1})", "babylon"), "");
}

TEST(SettingsJson, ErrorsNameTheLine) {
    EXPECT_EQ(errorOf("{\n  \"screen\": {\n    \"stpe\": 4\n  }\n}"),
              "my.json:3: unknown setting 'screen.stpe'; did you mean 'screen.step'?");
    EXPECT_EQ(errorOf("{\"screen\": {\n\n\n\"step\":\n400\n}}"),
              "my.json:4: screen.step = 400 is out of range [1, 64] px");
    EXPECT_EQ(errorOf("{\n\"screen.step\": 1.5}"), "my.json:2: screen.step: expected a whole number, got '1.5'");
    EXPECT_EQ(errorOf("{\n\"screen.step\": \"4\"}"), "my.json:2: screen.step: expected a whole number, got \"4\"");
    EXPECT_EQ(errorOf("{\n\"screen.smooth\": 1}"), "my.json:2: screen.smooth: expected true or false, got '1'");
    EXPECT_EQ(errorOf("{\n\"screen.smooth\": null}"), "my.json:2: screen.smooth: expected true or false, got 'null'");
    EXPECT_EQ(errorOf("{\"screen\": {\"step\": 2},\n\"screen.step\": 3}"), "my.json:2: screen.step is set twice");
    EXPECT_EQ(errorOf("{\n\"rays.cullMask\": \"0x0F\"}"),
              "my.json:2: rays.cullMask: expected a whole number, got \"0x0F\"");
}

TEST(SettingsJson, OnlyColoursAreLists) {
    EXPECT_EQ(errorOf("{\n\"screen.step\": [4]}"), "my.json:2: screen.step: expected a whole number, got [4]");
    EXPECT_EQ(errorOf("{\n\"screen.smooth\": []}"), "my.json:2: screen.smooth: expected true or false, got []");
    EXPECT_EQ(errorOf("{\n\"fade.border\": [1, 2]}"),
              "my.json:2: fade.border: expected none, smooth or linear, got [1, 2]");
    EXPECT_EQ(errorOf("{\"zzzzzzzz\":\n[4]}"),
              "my.json:1: unknown setting 'zzzzzzzz'; `glint settings` lists them all");
    for (const std::string list : {"[]", "[0.5]", "[0.1, 0.2]", "[0.1, 0.2, 0.3, 0.4]"})
        EXPECT_EQ(errorOf("{\n\"transmittanceColor\": " + list + "}"),
                  "my.json:2: transmittanceColor: expected a colour as R,G,B or one number, got " + list);
    for (const char* list : {"[\"red\"]", "[true, 0, 0]", "[null]", "[[1, 1, 1]]", "[{}]", "[{\"r\": 1}]"})
        EXPECT_EQ(
            errorOf("{\n\"transmittanceColor\": " + std::string(list) + "}"),
            "my.json:2: transmittanceColor: a list holds the numbers of a colour and nothing else: [0.9, 0.5, 0.2]");
    EXPECT_NE(errorOf(R"({"transmittanceColor": [2, 0, 0]})"), "") << "out of range";
    EXPECT_EQ(errorOf("{\"transmittanceColor\": [1, 1, 1],\n\"refraction.transmittanceRed\": 1}"),
              "my.json:2: refraction.transmittanceRed is set twice");
    EXPECT_EQ(errorOf("[4]"), "my.json:1: expected an object of settings: {\"screen\": {\"step\": 1}}");
}

TEST(SettingsJson, BrokenJsonIsOneLineWithItsNumber) {
    for (const std::string_view text : {"", " \n", "{", "{\n\"screen\": {\"step\": 4,}\n}", "[]", "4", "null", "{}{}",
                                        "{\"a\": 1e999}", "\xff\xfe", "{\"\xc3\": 1}", "{\"a\n\": 1}"}) {
        const std::string message = errorOf(text);
        EXPECT_EQ(message.substr(0, 8), "my.json:") << text;
        EXPECT_TRUE(std::ranges::none_of(message, [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
    }
    EXPECT_EQ(errorOf("{\n\"screen\": {\"step\": 4,}\n}").substr(0, 11), "my.json:2: ");
}

TEST(SettingsJson, DeepNestingIsAnErrorNotACrash) {
    std::string text;
    for (int i = 0; i < 100000; ++i)
        text += "{\"a\":";
    EXPECT_LT(errorOf(text + "1").size(), 300u);
}

TEST(SettingsJson, ARefusedFileChangesNothing) {
    Settings settings;
    EXPECT_FALSE(fromJson(settings, R"({"screen.step": 4, "screen.stpe": 4})", "my.json").ok());
    EXPECT_EQ(settings.screen.step, Settings{}.screen.step);
}

TEST(Presets, AllAreValidAndStartFromTheDefaults) {
    ASSERT_FALSE(presetNames().empty());
    for (std::string_view name : presetNames()) {
        Settings settings;
        settings.screen.selfCollisionSkip = 16;
        settings.screen.enabled = false;
        const auto done = applyPreset(settings, name);
        ASSERT_TRUE(done.ok()) << done.error().message;
        EXPECT_TRUE(validate(settings).ok()) << name;
        EXPECT_EQ(settings.screen.enabled, name != "ray-query" && name != "reference") << name;
        EXPECT_LE(settings.screen.selfCollisionSkip, 1) << name;
    }
}

TEST(Presets, BalancedIsTheDefaults) {
    Settings settings;
    ASSERT_TRUE(applyPreset(settings, "balanced").ok());
    EXPECT_EQ(toJson(settings), toJson(Settings{}));
}

/// Settings none of which has its default.
Settings withoutDefaults() {
    Settings settings;
    const SettingsTarget target{settingsTable(), &settings};
    for (const SettingInfo& info : settingsTable()) {
        double value = info.defaultValue == info.range.max ? info.range.min : info.range.max;
        if (info.type == SettingType::Boolean)
            value = 1 - info.defaultValue;
        else if (info.type == SettingType::Enum)
            value = info.defaultValue == 0 ? 1 : 0;
        const auto done = setSetting({&target, 1}, info.key, settingText(info, value), {});
        EXPECT_TRUE(done.ok()) << done.error().message;
        EXPECT_NE(settingValue(info, &settings), info.defaultValue) << info.key;
    }
    return settings;
}

// A system's preset states the system's own parameters, so that it keeps their values when a default of Glint changes.
TEST(Presets, NoneStatesADefaultButOfItsOwnSystemsParameters) {
    for (const std::string_view name : presetNames()) {
        Settings settings = withoutDefaults();
        const auto done = fromJson(settings, test::must(presetJson(name)), name, name);
        ASSERT_TRUE(done.ok()) << done.error().message;
        for (const SettingInfo& info : settingsTable())
            EXPECT_TRUE(settingValue(info, &settings) != info.defaultValue ||
                        std::ranges::find(info.aliases, name, &SettingAlias::system) != info.aliases.end())
                << "presets/" << name << ".json: remove " << info.key << ", which has this value by default";
    }
}

TEST(Presets, AnUnknownNameListsThem) {
    Settings settings;
    const auto done = applyPreset(settings, "babylom");
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().message,
              "unknown preset 'babylom'; there are babylon, balanced, compute-ssr, fast, hdrp, hybrid, "
              "quality, ray-query, real-time and reference");
}

TEST(Presets, FileBeatsPresetAndSetBeatsFile) {
    Settings settings;
    ASSERT_TRUE(applyPreset(settings, "babylon").ok());
    EXPECT_EQ(settings.screen.thickness, 0.5f);
    EXPECT_EQ(settings.reflect.threshold, 0.04f);
    ASSERT_TRUE(fromJson(settings, R"({"thickness": 0.25, "screen.step": 2})", "my.json", "babylon").ok());
    ASSERT_TRUE(set(settings, "thickness", "0.125", "babylon").ok());
    EXPECT_EQ(settings.screen.thickness, 0.125f);
    EXPECT_EQ(settings.screen.step, 2);
    EXPECT_EQ(settings.reflect.threshold, 0.04f);
}

} // namespace settings_json_test
} // namespace glint
