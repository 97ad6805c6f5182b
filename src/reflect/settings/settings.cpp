#include "glint/settings.hpp"

#include "base/settings/setting_rows.hpp"
#include "base/settings/settings_json.hpp"
#include "base/settings/settings_target.hpp"
#include "base/text.hpp"
#include "reflect/settings/presets.hpp"

#include <algorithm>

namespace glint {

static std::vector<SettingInfo> makeTable() {
    std::vector<SettingInfo> rows;
    GLINT_SETTING_GROUP(rows, Settings, screen, GLINT_SCREEN_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, hiz, GLINT_HIZ_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, adaptive, GLINT_ADAPTIVE_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, reflect, GLINT_REFLECT_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, rough, GLINT_ROUGH_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, blur, GLINT_BLUR_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, reuse, GLINT_REUSE_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, denoise, GLINT_DENOISE_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, fade, GLINT_FADE_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, rays, GLINT_RAYS_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, planar, GLINT_PLANAR_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, probes, GLINT_PROBES_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, sky, GLINT_SKY_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, refraction, GLINT_REFRACTION_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, order, GLINT_ORDER_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, composite, GLINT_COMPOSITE_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, gbuffer, GLINT_GBUFFER_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, input, GLINT_INPUT_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, output, GLINT_OUTPUT_SETTINGS)
    GLINT_SETTING_GROUP(rows, Settings, debug, GLINT_DEBUG_SETTINGS)
    return rows;
}

std::span<const SettingInfo> settingsTable() {
    static const std::vector<SettingInfo> table = makeTable();
    return table;
}

Result<void> set(Settings& settings, std::string_view key, std::string_view value, std::string_view preset) {
    const SettingsTarget target{settingsTable(), &settings};
    return setSetting({&target, 1}, key, value, preset);
}

Result<void> fromJson(Settings& settings, std::string_view text, std::string_view name, std::string_view preset) {
    const SettingsTarget target{settingsTable(), &settings};
    return readSettingsJson({&target, 1}, text, name, preset);
}

std::string toJson(const Settings& settings) {
    Settings copy = settings;
    const SettingsTarget target{settingsTable(), &copy};
    return writeSettingsJson({&target, 1});
}

Result<void> validate(const Settings& settings) {
    Settings copy = settings;
    const SettingsTarget target{settingsTable(), &copy};
    return validateSettings({&target, 1});
}

std::vector<std::string_view> presetNames() {
    std::vector<std::string_view> names;
    for (const EmbeddedPreset& preset : embeddedPresets())
        names.push_back(preset.name);
    return names;
}

Result<std::string_view> presetJson(std::string_view name) {
    const auto found = std::ranges::find(embeddedPresets(), name, &EmbeddedPreset::name);
    if (found == embeddedPresets().end()) {
        const std::vector<std::string_view> names = presetNames();
        return invalidArgument("unknown preset '{}'; there are {}", printable(name),
                               listText(std::vector<std::string>(names.begin(), names.end()), " and "));
    }
    return found->json;
}

Result<void> applyPreset(Settings& settings, std::string_view name) {
    GLINT_TRY(text, presetJson(name));
    Settings fresh;
    GLINT_CHECK(fromJson(fresh, text, formatText("presets/{}.json", name), name));
    settings = fresh;
    return {};
}

} // namespace glint
