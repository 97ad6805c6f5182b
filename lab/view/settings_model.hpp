// The settings as the user changes them: every change can be undone, and differences from the preset are known.
// Independent of the window; the panel, the keys and the palette all change settings through it.
#pragma once

#include "base/result.hpp"
#include "lab/job/program_settings.hpp"
#include "lab/view/undo_stack.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

class SettingsModel {
public:
    /// `request`   as on the command line, already checked
    /// `settings`  the result of `request`
    SettingsModel(render::SettingsRequest request, const render::ProgramSettings& settings);

    const render::ProgramSettings& settings() const { return state_.now; }
    uint64_t version() const { return version_; } ///< increases with every change

    double value(const SettingInfo& info) const;
    /// Returns the unchanged value: the preset's, or the scene's default.
    double baseline(const SettingInfo& info) const;
    bool changed(const SettingInfo& info) const { return value(info) != baseline(info); }
    size_t changedCount() const;

    /// Sets the value, clamped to the setting's range.
    /// `continues`  true within one gesture, such as the drag of a slider: it becomes one undo step
    void set(const SettingInfo& info, double value, bool continues = false);
    /// Sets by key or by other systems' names, as `--set` does. Errors: InvalidArgument.
    Result<void> assign(std::string_view key, std::string_view value);
    void reset(const SettingInfo& info);
    void resetAll();
    bool undo();
    bool redo();
    bool canUndo() const { return stack_.canUndo(); }
    bool canRedo() const { return stack_.canRedo(); }

    /// Replaces the scene's defaults after another scene was opened, also in the undo steps; the user's changes are
    /// kept.
    /// `defaults`  as SettingsRequest::defaults. Errors: InvalidArgument; nothing changes then.
    Result<void> suitScene(const std::vector<std::string>& defaults);
    /// Sets all settings to the preset's values. Errors: InvalidArgument.
    Result<void> usePreset(std::string_view name);
    /// Loads a file on top of the active preset. Errors: as render::loadSettings; nothing changes then.
    Result<void> load(const std::string& path);
    /// Writes a file that `--settings` reads. Errors: Io.
    Result<void> save(const std::string& path) const;

    /// Returns the options that give these settings, such as "--preset fast --set screen.step=4".
    std::string options() const;

    /// Returns the settings whose key, meaning or other systems' names match `text`: names by fuzzyScore, the meaning
    /// by substring. For an empty text all settings in the table's order, otherwise the best match first.
    std::vector<const SettingInfo*> search(std::string_view text) const;

private:
    struct State {
        render::SettingsRequest request; ///< preset and scene defaults, which form the baseline
        render::ProgramSettings now;
        render::ProgramSettings baseline;
    };
    /// Applies the same changes to another baseline.
    static Result<void> suit(State& state, const std::vector<std::string>& defaults);
    void change(bool continues);
    static void* object(const SettingInfo& info, render::ProgramSettings& settings);

    State state_;
    UndoStack<State> stack_;
    uint64_t version_ = 1;
};

/// Returns the setting of this key. An unknown key is a programming error.
const SettingInfo& settingOf(std::string_view key);

} // namespace glint::view
