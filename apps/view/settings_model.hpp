// The settings as a person tunes them: every change can be taken back, and what differs from the preset is known.
// Knows no window; the panel, the keys and the palette all change settings through it.
#pragma once

#include "base/result.hpp"
#include "render/program_settings.hpp"
#include "undo_stack.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

class SettingsModel {
public:
    /// `request`  as the command line states it; it has been checked. `settings` are what it comes to
    SettingsModel(render::SettingsRequest request, const render::ProgramSettings& settings);

    const render::ProgramSettings& settings() const { return state_.now; }
    uint64_t version() const { return version_; } ///< grows with every change

    double value(const SettingInfo& info) const;
    /// What it is without changes: the preset's, or the scene's own.
    double baseline(const SettingInfo& info) const;
    bool changed(const SettingInfo& info) const { return value(info) != baseline(info); }
    size_t changedCount() const;

    /// Takes the value if it is in range, else the nearest that is.
    /// `continues`  the gesture of the call before, as when a slider is dragged: one step to take back
    void set(const SettingInfo& info, double value, bool continues = false);
    /// By key or other systems' names, as `--set` does. Errors: InvalidArgument.
    Result<void> assign(std::string_view key, std::string_view value);
    void reset(const SettingInfo& info);
    void resetAll();
    bool undo();
    bool redo();
    bool canUndo() const { return stack_.canUndo(); }
    bool canRedo() const { return stack_.canRedo(); }

    /// Another scene: what suits it takes the place of what suited the one before, also in what undo brings back; what
    /// was changed stays as it is.
    /// `defaults`  as SettingsRequest::defaults. Errors: InvalidArgument; nothing changes then.
    Result<void> suitScene(const std::vector<std::string>& defaults);
    /// All settings as the preset has them. Errors: InvalidArgument.
    Result<void> usePreset(std::string_view name);
    /// On top of the preset in force. Errors: as render::loadSettings gives them; nothing changes then.
    Result<void> load(const std::string& path);
    /// What `--settings` reads. Errors: Io.
    Result<void> save(const std::string& path) const;

    /// "--preset fast --set screen.step=4": those options that make these settings from nothing.
    std::string options() const;

    /// Those whose key, meaning or other systems' names answer to `text`, as fuzzyScore has it for names and as a part
    /// of the meaning; all in the table's order for an empty text, else the best first.
    std::vector<const SettingInfo*> search(std::string_view text) const;

private:
    struct State {
        render::SettingsRequest request; ///< preset and the scene's defaults: they make the baseline
        render::ProgramSettings now;
        render::ProgramSettings baseline;
    };
    /// The same changes to another baseline.
    static Result<void> suit(State& state, const std::vector<std::string>& defaults);
    void change(bool continues);
    static void* object(const SettingInfo& info, render::ProgramSettings& settings);

    State state_;
    UndoStack<State> stack_;
    uint64_t version_ = 1;
};

/// The setting of this key. A key that is none is a programmer's mistake.
const SettingInfo& settingOf(std::string_view key);

} // namespace glint::view
