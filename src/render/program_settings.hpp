// The settings of our own programs as one whole: the library's and the renderer's, under one table and in one JSON.
#pragma once

#include "base/settings/settings_target.hpp"
#include "glint/settings.hpp"
#include "render/render_settings.hpp"

#include <array>
#include <string>
#include <vector>

namespace glint::render {

struct ProgramSettings {
    Settings reflections;
    RenderSettings render;
    std::string preset = "balanced"; ///< the one in force: it decides what a bare alias means

    /// Both tables with the objects above; valid as long as this object stays where it is.
    std::array<SettingsTarget, 2> targets() {
        return {{{settingsTable(), &reflections}, {renderSettingsTable(), &render}}};
    }
};

/// What was asked for, weakest first.
struct SettingsRequest {
    std::vector<std::string> defaults;    ///< "key=value" that suit a scene better than the table's defaults
    std::string preset;                   ///< empty: balanced
    std::string file;                     ///< JSON; empty: none
    std::vector<std::string> assignments; ///< "key=value", in order
};

/// Errors: InvalidArgument, InvalidInput or NotFound; they name the file and the line, or `--set` and the assignment.
Result<ProgramSettings> loadSettings(const SettingsRequest& request);

/// Every setting as nested JSON, which `loadSettings` reads.
std::string settingsJson(const ProgramSettings& settings);

/// The library's table and the renderer's.
std::array<std::span<const SettingInfo>, 2> allSettings();

/// docs/settings.md
std::string settingsPage();

} // namespace glint::render
