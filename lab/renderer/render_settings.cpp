#include "lab/renderer/render_settings.hpp"

#include "base/settings/setting_rows.hpp"

namespace glint::render {

static std::vector<SettingInfo> makeTable() {
    std::vector<SettingInfo> rows;
    GLINT_SETTING_GROUP(rows, RenderSettings, environment, GLINT_ENVIRONMENT_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, analyticSky, GLINT_ANALYTIC_SKY_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, lights, GLINT_LIGHTS_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, shadows, GLINT_SHADOWS_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, mirrors, GLINT_MIRRORS_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, transparent, GLINT_TRANSPARENT_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, display, GLINT_DISPLAY_SETTINGS)
    GLINT_SETTING_GROUP(rows, RenderSettings, measure, GLINT_MEASURE_SETTINGS)
    return rows;
}

std::span<const SettingInfo> renderSettingsTable() {
    static const std::vector<SettingInfo> table = makeTable();
    return table;
}

} // namespace glint::render
