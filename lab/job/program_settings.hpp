// The settings of our own programs: the library's and the renderer's, under one table and in one JSON object.
#pragma once

#include "base/settings/settings_target.hpp"
#include "glint/settings.hpp"
#include "lab/renderer/render_settings.hpp"

#include <array>
#include <string>
#include <vector>

namespace glint::render {

struct ProgramSettings {
    Settings reflections;
    RenderSettings render;
    std::string preset = "balanced"; ///< the active preset: it determines what an alias without a prefix means

    /// Returns both tables with the objects above; valid until this object moves or is destroyed.
    std::array<SettingsTarget, 2> targets() {
        return {{{settingsTable(), &reflections}, {renderSettingsTable(), &render}}};
    }
};

/// The requested settings, in increasing precedence.
struct SettingsRequest {
    std::vector<std::string> defaults;    ///< "key=value": the scene's defaults, where they differ from the table's
    std::string preset;                   ///< empty: balanced
    std::string file;                     ///< JSON; empty: none
    std::vector<std::string> assignments; ///< "key=value", in order
};

/// Errors: InvalidArgument, InvalidInput or NotFound, with the file and line, or with `--set` and the assignment.
Result<ProgramSettings> loadSettings(const SettingsRequest& request);

/// Returns every setting as nested JSON, which `loadSettings` reads.
std::string settingsJson(const ProgramSettings& settings);

/// Returns the library's table and the renderer's.
std::array<std::span<const SettingInfo>, 2> allSettings();

/// Returns the text of docs/settings.md.
std::string settingsPage();

} // namespace glint::render
