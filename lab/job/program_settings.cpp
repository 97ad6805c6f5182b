#include "lab/job/program_settings.hpp"

#include "base/file.hpp"
#include "base/settings/settings_docs.hpp"
#include "base/settings/settings_json.hpp"
#include "base/text.hpp"

#include <nlohmann/json.hpp>

namespace glint::render {

static constexpr size_t kLongestSettingsFile = 1 << 20; // bytes; all settings with their values take a few thousand

static Result<void> assign(SettingsTargets targets, std::span<const std::string> assignments,
                           const std::string& preset) {
    for (const std::string_view assignment : assignments) {
        const size_t equals = assignment.find('=');
        if (equals == assignment.npos)
            return invalidArgument("--set {}: expected KEY=VALUE", printable(assignment));
        auto done = setSetting(targets, assignment.substr(0, equals), assignment.substr(equals + 1), preset);
        if (!done)
            return makeError(done.error().code, "--set {}: {}", printable(assignment), done.error().message);
    }
    return {};
}

Result<ProgramSettings> loadSettings(const SettingsRequest& request) {
    ProgramSettings settings;
    if (!request.preset.empty())
        settings.preset = request.preset;
    const auto targets = settings.targets();
    GLINT_CHECK(assign(targets, request.defaults, settings.preset));
    GLINT_TRY(preset, presetJson(settings.preset));
    GLINT_CHECK(readSettingsJson(targets, preset, fmt::format("presets/{}.json", settings.preset), settings.preset));
    if (!request.file.empty()) {
        GLINT_TRY(text, readFile(request.file, kLongestSettingsFile));
        GLINT_CHECK(readSettingsJson(targets, text, request.file, settings.preset));
    }
    GLINT_CHECK(assign(targets, request.assignments, settings.preset));
    return settings;
}

std::string settingsJson(const ProgramSettings& settings) {
    ProgramSettings copy = settings;
    return writeSettingsJson(copy.targets());
}

std::array<std::span<const SettingInfo>, 2> allSettings() {
    return {settingsTable(), renderSettingsTable()};
}

std::string settingsPage() {
    std::string page =
        "# Settings\n\n"
        "Written by `glint settings --markdown`; the lists are include/glint/settings_list.hpp and\n"
        "lab/renderer/render_settings.hpp.\n\n"
        "Every setting can be given as `--set KEY=VALUE`, in a JSON file (`--settings FILE`, nested\n"
        "`{\"screen\": {\"step\": 2}}` or flat `{\"screen.step\": 2}`) and by a preset (`--preset NAME`).\n"
        "A preset is weaker than a file, a file is weaker than `--set`. In ranges, `(` and `)` leave the\n"
        "end out. The last column holds names of other systems, which work wherever a key does. A name\n"
        "without its system works where one system alone has it, or under that system's preset.\n\n"
        "Values that are names are read in any case: `HiZ` is `hiz`. `--set` also takes whole numbers in\n"
        "hexadecimal (`rays.cullMask=0x0F`). A colour of another system is `R,G,B` or one number; in JSON\n"
        "also a list: `{\"hdrp:transmittanceColor\": [0.9, 0.5, 0.2]}`.\n\n"
        "| Preset | |\n|---|---|\n";
    for (const std::string_view name : presetNames()) {
        const auto json = nlohmann::json::parse(*presetJson(name), nullptr, false);
        page += fmt::format("| `{}` | {} |\n", name, json.value("description", ""));
    }
    return page + "\n" + settingsMarkdown(allSettings()) +
           "\n## What `glint tune` varies\n\n"
           "The settings of the [search](tune.md), the values worth searching, and when a setting has an effect: the\n"
           "settings that it depends on must have one themselves.\n\n" +
           searchMarkdown(allSettings());
}

} // namespace glint::render
