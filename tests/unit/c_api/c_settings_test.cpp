// Settings through the C interface: by name, by number, as JSON, and the table that describes them.
#include "glint/glint.h"
#include "glint/settings.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <memory>

namespace glint {
namespace c_settings_test {

using testing::HasSubstr;

struct DestroySettings {
    void operator()(GlintSettings* settings) const { glint_settings_destroy(settings); }
};
using Owned = std::unique_ptr<GlintSettings, DestroySettings>;

Owned create() {
    GlintSettings* settings = nullptr;
    EXPECT_EQ(glint_settings_create(&settings), GLINT_SUCCESS);
    return Owned(settings);
}

std::string jsonOf(const GlintSettings* settings) {
    std::string text(glint_settings_to_json(settings, nullptr, 0) + 1, '?');
    EXPECT_EQ(glint_settings_to_json(settings, text.data(), text.size()), text.size() - 1);
    EXPECT_EQ(text.back(), '\0');
    text.pop_back();
    return text;
}

double numberOf(const GlintSettings* settings, const char* key) {
    double value = -1;
    EXPECT_EQ(glint_settings_get_number(settings, key, &value), GLINT_SUCCESS) << glint_last_error();
    return value;
}

TEST(CSettings, TheTableIsTheOneOfCpp) {
    const std::span<const SettingInfo> table = settingsTable();
    ASSERT_EQ(glint_setting_count(), table.size());
    const Owned settings = create();
    for (uint32_t i = 0; i < table.size(); ++i) {
        GlintSettingInfo info;
        glint_setting_info_init(&info, sizeof info);
        ASSERT_EQ(glint_setting_info(i, &info), GLINT_SUCCESS);
        EXPECT_EQ(info.key, table[i].key);
        EXPECT_EQ(info.meaning, table[i].meaning);
        EXPECT_EQ(info.unit, table[i].unit);
        EXPECT_EQ(info.max, table[i].range.max);
        ASSERT_EQ(info.choiceCount, table[i].choices.size());
        for (uint32_t choice = 0; choice < info.choiceCount; ++choice)
            EXPECT_EQ(info.choices[choice], table[i].choices[choice]);
        EXPECT_EQ(numberOf(settings.get(), info.key), info.defaultValue) << info.key;
        // Another value of each setting, and back.
        const double other = info.type == GLINT_SETTING_BOOLEAN  ? 1 - info.defaultValue
                             : info.type == GLINT_SETTING_CHOICE ? info.choiceCount - 1
                             : info.maxOpen                      ? info.defaultValue
                                                                 : info.max;
        ASSERT_EQ(glint_settings_set_number(settings.get(), info.key, other), GLINT_SUCCESS) << glint_last_error();
        EXPECT_EQ(numberOf(settings.get(), info.key),
                  info.type == GLINT_SETTING_FLOAT ? static_cast<double>(static_cast<float>(other)) : other)
            << info.key;
        ASSERT_EQ(glint_settings_set_number(settings.get(), info.key, info.defaultValue), GLINT_SUCCESS);
    }
    EXPECT_EQ(jsonOf(settings.get()), toJson(Settings()));
    GlintSettingInfo info;
    glint_setting_info_init(&info, sizeof info);
    EXPECT_EQ(glint_setting_info(glint_setting_count(), &info), GLINT_ERROR_INVALID_ARGUMENT);
}

TEST(CSettings, NamesAndJsonAndPresetsMeanTheSame) {
    const Owned byName = create();
    ASSERT_EQ(glint_settings_set(byName.get(), "babylon:maxDistance", "20", nullptr), GLINT_SUCCESS);
    EXPECT_EQ(numberOf(byName.get(), "screen.maxDistance"), 20);
    ASSERT_EQ(glint_settings_set(byName.get(), "ray-query:cull_mask", "0x0F", nullptr), GLINT_SUCCESS);
    EXPECT_EQ(numberOf(byName.get(), "rays.cullMask"), 15);
    ASSERT_EQ(glint_settings_set(byName.get(), "hdrp:projectionModel", "Proxy", nullptr), GLINT_SUCCESS);
    EXPECT_EQ(numberOf(byName.get(), "screen.march"), static_cast<double>(March::Proxy));
    const Owned byJson = create();
    const std::string text = jsonOf(byName.get());
    ASSERT_EQ(glint_settings_from_json(byJson.get(), text.data(), text.size(), "copy", nullptr), GLINT_SUCCESS);
    EXPECT_EQ(jsonOf(byJson.get()), text);
    ASSERT_NE(glint_preset_count(), 0u);
    EXPECT_EQ(glint_preset_name(glint_preset_count()), nullptr);
    for (uint32_t i = 0; i < glint_preset_count(); ++i) {
        ASSERT_EQ(glint_settings_apply_preset(byJson.get(), glint_preset_name(i)), GLINT_SUCCESS);
        Settings cpp;
        ASSERT_TRUE(applyPreset(cpp, glint_preset_name(i)).ok());
        EXPECT_EQ(jsonOf(byJson.get()), toJson(cpp)) << glint_preset_name(i);
    }
}

TEST(CSettings, JsonIsCutToTheHostsCapacity) {
    const Owned settings = create();
    char text[8];
    std::memset(text, '?', sizeof text);
    EXPECT_EQ(glint_settings_to_json(settings.get(), text, 5), jsonOf(settings.get()).size());
    EXPECT_EQ(std::string(text), jsonOf(settings.get()).substr(0, 4));
    EXPECT_EQ(text[5], '?');
}

TEST(CSettings, MistakesAreErrorsAndChangeNothing) {
    const Owned settings = create();
    const std::string before = jsonOf(settings.get());
    const auto expectError = [&](GlintResult result, const char* text) {
        EXPECT_EQ(result, GLINT_ERROR_INVALID_ARGUMENT);
        EXPECT_THAT(glint_last_error(), HasSubstr(text));
        EXPECT_EQ(jsonOf(settings.get()), before);
    };
    expectError(glint_settings_set(settings.get(), "screen.maxDistanc", "2", nullptr), "screen.maxDistance");
    expectError(glint_settings_set(settings.get(), "screen.maxDistance", "-2", nullptr), "screen.maxDistance");
    expectError(glint_settings_set_number(settings.get(), "screen.maxDistanc", 2), "screen.maxDistance");
    expectError(glint_settings_set_number(settings.get(), "screen.maxDistance", -2), "screen.maxDistance");
    expectError(glint_settings_set_number(settings.get(), "screen.march", 1.5), "whole number");
    expectError(glint_settings_set_number(settings.get(), "screen.march", 99), "whole number");
    expectError(glint_settings_set_number(settings.get(), "rays.enabled", 2), "whole number");
    expectError(glint_settings_set(settings.get(), nullptr, "2", nullptr), "key is null");
    expectError(glint_settings_set(nullptr, "screen.maxDistance", "2", nullptr), "settings is null");
    expectError(glint_settings_apply_preset(settings.get(), "none such"), "none such");
    EXPECT_EQ(glint_settings_from_json(settings.get(), "{", 1, "my.json", nullptr), GLINT_ERROR_INVALID_INPUT);
    EXPECT_THAT(glint_last_error(), HasSubstr("my.json:1"));
    const std::string longName(5000, 'x');
    expectError(glint_settings_apply_preset(settings.get(), longName.c_str()), "xxx");
    EXPECT_EQ(jsonOf(nullptr), "");
}

} // namespace c_settings_test
} // namespace glint
