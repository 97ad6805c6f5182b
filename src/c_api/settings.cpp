#include "base/text.hpp"
#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

#include <cmath>

using namespace glint;
using namespace glint::c_api;

namespace {

/// The table's choices as C has them. Made once, with the table.
std::vector<std::vector<const char*>> makeChoices() {
    std::vector<std::vector<const char*>> all;
    for (const SettingInfo& info : settingsTable()) {
        std::vector<const char*>& names = all.emplace_back();
        for (const std::string& name : info.choices)
            names.push_back(name.c_str());
    }
    return all;
}

Result<const SettingInfo*> findSetting(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const SettingInfo& info : settingsTable()) {
        if (info.key == key)
            return &info;
        keys.emplace_back(info.key);
    }
    return invalidArgument("no setting '{}'; did you mean '{}'?", printable(key), nearestText(key, keys));
}

/// The setting's place in `settings`, as one of the four types that settings have.
template <class T>
T& place(const SettingInfo& info, Settings& settings) {
    return *reinterpret_cast<T*>(reinterpret_cast<unsigned char*>(&settings) + info.offset);
}

std::string_view orEmpty(const char* text) {
    return text ? text : "";
}

} // namespace

void glint_setting_info_init(GlintSettingInfo* info, uint32_t size) {
    initStruct<SettingInfo>(info, size);
}

uint32_t glint_setting_count(void) {
    return static_cast<uint32_t>(settingsTable().size());
}

GlintResult glint_setting_info(uint32_t index, GlintSettingInfo* info) {
    GLINT_C_CHECK(checkResultStruct<SettingInfo>(info));
    const std::span<const SettingInfo> table = settingsTable();
    if (index >= table.size())
        return fail(invalidArgument("no setting {}: there are {}", index, table.size()));
    static const std::vector<std::vector<const char*>> choices = makeChoices();
    const SettingInfo& row = table[index];
    GlintSettingInfo result = {};
    result.type = static_cast<GlintSettingType>(row.type);
    result.key = row.key.c_str();
    result.unit = row.unit.c_str();
    result.meaning = row.meaning.c_str();
    result.defaultValue = row.defaultValue;
    result.min = row.range.min;
    result.max = row.range.max;
    result.minOpen = row.range.minOpen ? VK_TRUE : VK_FALSE;
    result.maxOpen = row.range.maxOpen ? VK_TRUE : VK_FALSE;
    result.choices = choices[index].data();
    result.choiceCount = static_cast<uint32_t>(choices[index].size());
    writeStruct(result, info, info->size);
    return GLINT_SUCCESS;
}

uint32_t glint_preset_count(void) {
    return static_cast<uint32_t>(presetNames().size());
}

const char* glint_preset_name(uint32_t index) {
    const std::vector<std::string_view> names = presetNames();
    return index < names.size() ? names[index].data() : nullptr; // literals, which end in a zero
}

GlintResult glint_settings_create(GlintSettings** settings) {
    GLINT_C_REQUIRE(settings);
    *settings = new GlintSettings();
    return GLINT_SUCCESS;
}

void glint_settings_destroy(GlintSettings* settings) {
    delete settings;
}

GlintResult glint_settings_set(GlintSettings* settings, const char* key, const char* value, const char* preset) {
    GLINT_C_REQUIRE(settings);
    GLINT_C_REQUIRE(key);
    GLINT_C_REQUIRE(value);
    return outcome(set(settings->settings, key, value, orEmpty(preset)));
}

GlintResult glint_settings_set_number(GlintSettings* settings, const char* key, double value) {
    GLINT_C_REQUIRE(settings);
    GLINT_C_REQUIRE(key);
    GLINT_C_TRY(info, findSetting(key));
    Settings changed = settings->settings;
    if (info->type == SettingType::Float) {
        place<float>(*info, changed) = static_cast<float>(value);
    } else {
        const bool boolean = info->type == SettingType::Boolean;
        const double most = boolean                           ? 1
                            : info->type == SettingType::Enum ? static_cast<double>(info->choices.size()) - 1
                                                              : info->range.max;
        const double least = info->type == SettingType::Int ? info->range.min : 0;
        if (!(value >= least && value <= most) || value != std::floor(value))
            return fail(invalidArgument("{} {}: a whole number from {} to {}", info->key, value, least, most));
        if (boolean)
            place<bool>(*info, changed) = value != 0;
        else
            place<int>(*info, changed) = static_cast<int>(value);
    }
    GLINT_C_CHECK(validate(changed));
    settings->settings = changed;
    return GLINT_SUCCESS;
}

GlintResult glint_settings_get_number(const GlintSettings* settings, const char* key, double* value) {
    GLINT_C_REQUIRE(settings);
    GLINT_C_REQUIRE(key);
    GLINT_C_REQUIRE(value);
    GLINT_C_TRY(info, findSetting(key));
    Settings copy = settings->settings;
    switch (info->type) {
    case SettingType::Boolean: *value = place<bool>(*info, copy) ? 1 : 0; break;
    case SettingType::Float: *value = static_cast<double>(place<float>(*info, copy)); break;
    case SettingType::Int:
    case SettingType::Enum: *value = place<int>(*info, copy); break;
    }
    return GLINT_SUCCESS;
}

GlintResult glint_settings_from_json(GlintSettings* settings, const char* text, size_t length, const char* name,
                                     const char* preset) {
    GLINT_C_REQUIRE(settings);
    GLINT_C_REQUIRE(text);
    return outcome(fromJson(settings->settings, {text, length}, name ? name : "JSON", orEmpty(preset)));
}

size_t glint_settings_to_json(const GlintSettings* settings, char* text, size_t capacity) {
    const std::string json = settings ? toJson(settings->settings) : std::string();
    if (text && capacity > 0) {
        const size_t length = std::min(json.size(), capacity - 1);
        std::memcpy(text, json.data(), length);
        text[length] = '\0';
    }
    return json.size();
}

GlintResult glint_settings_apply_preset(GlintSettings* settings, const char* name) {
    GLINT_C_REQUIRE(settings);
    GLINT_C_REQUIRE(name);
    return outcome(applyPreset(settings->settings, name));
}
