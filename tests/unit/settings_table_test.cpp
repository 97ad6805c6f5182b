// The library's own settings: what every row of the list must hold, key by key and alias by alias.
#include "glint/settings.hpp"

#include "base/settings/settings_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace glint {
namespace settings_table_test {

/// A value that the setting takes and that is not its default.
std::string otherValue(const SettingInfo& info) {
    switch (info.type) {
    case SettingType::Boolean: return info.defaultValue != 0 ? "false" : "true";
    case SettingType::Int: return info.defaultValue == info.range.max ? "1" : fmt::format("{}", info.range.max);
    case SettingType::Float: return info.defaultValue == info.range.max ? "0.125" : fmt::format("{}", info.range.max);
    case SettingType::Enum: break;
    }
    return info.choices.back();
}

double valueIn(const Settings& settings, const SettingInfo& info) {
    return settingValue(info, &settings);
}

TEST(SettingsTable, StructHoldsTheDefaultsOfTheTable) {
    const Settings settings;
    for (const SettingInfo& info : settingsTable())
        EXPECT_EQ(valueIn(settings, info), info.defaultValue) << info.key;
}

TEST(SettingsTable, DefaultsAreInRange) {
    EXPECT_TRUE(validate(Settings{}).ok());
}

TEST(SettingsTable, KeysAreUniqueAndMeaningsAreOneLine) {
    std::set<std::string> keys;
    for (const SettingInfo& info : settingsTable()) {
        EXPECT_TRUE(keys.insert(info.key).second) << info.key;
        EXPECT_NE(info.key.find('.'), std::string::npos) << info.key;
        EXPECT_FALSE(info.meaning.empty()) << info.key;
        EXPECT_EQ(info.meaning.find('\n'), std::string::npos) << info.key;
    }
}

TEST(SettingsTable, EveryKeyTakesAValueFromText) {
    for (const SettingInfo& info : settingsTable()) {
        Settings settings;
        const std::string text = otherValue(info);
        const auto done = set(settings, info.key, text);
        ASSERT_TRUE(done.ok()) << done.error().message;
        const bool number = info.type == SettingType::Int;
        const double value = valueIn(settings, info);
        if (info.type == SettingType::Float) // as a float holds it
            EXPECT_EQ(value, static_cast<double>(std::stof(text))) << info.key;
        else
            EXPECT_EQ(number ? fmt::format("{}", value) : settingText(info, value), text);
        for (const SettingInfo& other : settingsTable()) {
            if (other.key == info.key)
                continue;
            EXPECT_EQ(valueIn(settings, other), other.defaultValue) << info.key << " changed " << other.key;
        }
    }
}

TEST(SettingsTable, EveryKeyRoundTripsThroughJson) {
    for (const SettingInfo& info : settingsTable()) {
        Settings written;
        ASSERT_TRUE(set(written, info.key, otherValue(info)).ok()) << info.key;
        Settings read;
        const auto done = fromJson(read, toJson(written), "round-trip");
        ASSERT_TRUE(done.ok()) << done.error().message;
        for (const SettingInfo& each : settingsTable())
            EXPECT_EQ(valueIn(read, each), valueIn(written, each)) << info.key << ": " << each.key;
    }
}

TEST(SettingsTable, FloatsRoundTripToTheSameBits) {
    for (float value : {0.1f, 1.0f / 3, 1e-30f, 999.99994f, std::nextafter(0.5f, 1.0f)}) {
        Settings written;
        written.screen.thickness = value;
        Settings read;
        ASSERT_TRUE(fromJson(read, toJson(written), "round-trip").ok());
        EXPECT_EQ(read.screen.thickness, value);
    }
}

TEST(SettingsTable, RangesHoldAtBothEnds) {
    for (const SettingInfo& info : settingsTable()) {
        if (info.range.text.empty())
            continue;
        for (const bool upper : {false, true}) {
            const double end = upper ? info.range.max : info.range.min;
            const bool open = upper ? info.range.maxOpen : info.range.minOpen;
            const double outside = end + (upper ? 1 : -1) * std::max(1.0, std::floor(std::abs(end) * 1e-3));
            Settings settings;
            EXPECT_EQ(set(settings, info.key, fmt::format("{}", end)).ok(), !open) << info.key << " = " << end;
            const auto refused = set(settings, info.key, fmt::format("{}", outside));
            ASSERT_FALSE(refused.ok()) << info.key << " = " << outside;
            EXPECT_NE(refused.error().message.find(info.range.text), std::string::npos) << refused.error().message;
        }
    }
}

TEST(SettingsTable, ValidateFindsWhatAHostWroteIntoTheStruct) {
    for (const SettingInfo& info : settingsTable()) {
        if (info.type != SettingType::Float)
            continue;
        Settings settings;
        auto* const member = reinterpret_cast<float*>(reinterpret_cast<std::byte*>(&settings) + info.offset);
        *member = std::numeric_limits<float>::quiet_NaN();
        const auto found = validate(settings);
        ASSERT_FALSE(found.ok()) << info.key;
        EXPECT_EQ(found.error().message.substr(0, info.key.size()), info.key);
    }
    Settings settings;
    settings.screen.step = 0;
    EXPECT_EQ(validate(settings).error().message, "screen.step = 0 is out of range [1, 64] px");
    settings = {};
    settings.screen.thicknessMode = static_cast<ThicknessMode>(7);
    EXPECT_EQ(validate(settings).error().message, "screen.thicknessMode = 7 is none of constant, relative, backface");
}

TEST(SettingsTable, EndsOfARangeThatAreNoFloatsAreValid) {
    Settings settings;
    settings.denoise.disocclusion = 0.2f;  // above 0.2
    settings.denoise.noiseTarget = 0.005f; // below 0.005
    settings.reflect.falloffExponent = 16;
    settings.screen.maxDistance = 1e6f;
    EXPECT_TRUE(validate(settings).ok());
}

TEST(SettingsTable, TinyNumbersThatAFloatHoldsAsZeroAreOutsideAnOpenRange) {
    Settings settings;
    EXPECT_FALSE(set(settings, "screen.maxDistance", "1e-60").ok());
    EXPECT_FALSE(set(settings, "screen.maxDistance", "nan").ok());
    EXPECT_FALSE(set(settings, "screen.maxDistance", "inf").ok());
    EXPECT_EQ(settings.screen.maxDistance, 1000);
}

TEST(SettingsTable, EveryAliasIsTaken) {
    for (const SettingInfo& info : settingsTable()) {
        for (const SettingAlias& alias : info.aliases) {
            std::string value = otherValue(info);
            if (alias.transform == AliasTransform::OneMinus)
                value = "0.25";
            else if (alias.transform == AliasTransform::InverseOnePlus)
                value = "1";
            else if (alias.transform == AliasTransform::Choice)
                value = "false";
            else if (alias.transform == AliasTransform::Fixed || alias.transform == AliasTransform::Instead)
                value = "0.375"; // these stand beside a number in [0, 0.5]
            Settings settings;
            const std::string name = alias.system + ":" + alias.name;
            const auto done = set(settings, name, value);
            EXPECT_TRUE(done.ok()) << name << ": " << done.error().message;
            EXPECT_TRUE(set(settings, alias.name, value, alias.system).ok()) << alias.name;
        }
    }
}

} // namespace settings_table_test
} // namespace glint
