#include "lab/view/view_commands.hpp"

#include "base/text.hpp"
#include "lab/session/views.hpp"
#include "lab/view/key_names.hpp"
#include "lab/view/ssr_keys.hpp"

#include <algorithm>
#include <filesystem>

namespace glint::view {
namespace {

/// "glint-3.png": the first such name without a file.
std::string freeName(const std::string& ending) {
    std::error_code ignored;
    for (int i = 1;; ++i)
        if (std::string name = fmt::format("glint-{}{}", i, ending); !std::filesystem::exists(name, ignored))
            return name;
}

void toggleBeside(ViewerState& state) {
    state.beside = state.beside == Beside::Nothing ? Beside::Settings : Beside::Nothing;
    if (state.beside == Beside::Nothing)
        state.heat = Heat::None;
}

void nextHeat(ViewerState& state) {
    state.heat = state.heat == Heat::None ? Heat::Difference : state.heat == Heat::Difference ? Heat::Flip : Heat::None;
    if (state.heat != Heat::None)
        state.beside = Beside::Settings;
}

void zoom(ViewerState& state, float factor) {
    state.zoom.factor = std::clamp(state.zoom.factor * factor, 1.0f, 256.0f);
}

void escape(ViewerState& state) {
    if (state.showPalette || state.open.shown) {
        state.showPalette = state.open.shown = false;
    } else {
        state.asked.reset();
        state.askFollows = false;
    }
}

void togglePalette(ViewerState& state) {
    state.showPalette = !state.showPalette;
    state.paletteOpens = state.showPalette;
    state.open.shown = false;
}

void toggleOpenPanel(ViewerState& state) {
    state.open.shown = !state.open.shown;
    state.open.begins = state.open.shown;
    state.open.text.clear();
    state.showPalette = false;
}

std::vector<ViewCommand> makeCommands() {
    std::vector<ViewCommand> list = {
        {"Command palette", "Ctrl+P", togglePalette, true},
        {"Next view: " + listText(std::vector<std::string>(kCycledViews.begin(), kCycledViews.end()), ", "), "V",
         [](ViewerState& s) { s.view = nextView(s.view), s.say("view " + s.view); }},
        {"Help and times", "H", [](ViewerState& s) { s.showHelp = !s.showHelp; }},
        {"Settings panel", "Tab", [](ViewerState& s) { s.showSettings = !s.showSettings; }},
        {"Materials panel", "M", [](ViewerState& s) { s.showMaterials = !s.showMaterials; }},
        {"Graph of pass times", "T", [](ViewerState& s) { s.showTimes = !s.showTimes; }},
        {"Hide or show all panels", "F1", [](ViewerState& s) { s.showPanels = !s.showPanels; }, true},
        {"Undo", "Ctrl+Z", [](ViewerState& s) { s.say(s.settings.undo() ? "undone" : "nothing to undo"); }},
        {"Redo", "Ctrl+Y", [](ViewerState& s) { s.say(s.settings.redo() ? "redone" : "nothing to redo"); }},
        {"Reset all settings", "", [](ViewerState& s) { s.settings.resetAll(); }},
        {"Split screen: the reference beside", "B", toggleBeside},
        {"Error against what is beside: none, difference, FLIP", "N", nextHeat},
        {"Ask the pixel under the mouse", "Home", [](ViewerState& s) { s.askFollows = !s.askFollows; }},
        {"Second camera: the asked ray in the world", "O", [](ViewerState& s) { s.second.shown = !s.second.shown; }},
        {"Close, or ask no pixel", "Escape", escape, true},
        {"Play or pause the animation", "Space", [](ViewerState& s) { s.animation.playing = !s.animation.playing; }},
        {"Zoom in to single pixels", "PageUp", [](ViewerState& s) { zoom(s, 2); }},
        {"Zoom out", "PageDown", [](ViewerState& s) { zoom(s, 0.5f); }},
        {"Next camera of the scene", "C",
         [](ViewerState& s) {
             if (s.cameras.empty())
                 return s.say("the scene has no cameras");
             s.cameraIndex = (s.cameraIndex + 1) % static_cast<int>(s.cameras.size());
             s.camera = OrbitCamera(s.cameras[static_cast<size_t>(s.cameraIndex)], s.camera.distance());
             s.say("camera " + s.cameras[static_cast<size_t>(s.cameraIndex)].name);
         }},
        {"Screenshot of the window (PNG)", "F12",
         [](ViewerState& s) { s.ask(Request::Kind::Screenshot, freeName(".png")); }, true},
        {"Picture as glint render writes it (PNG)", "F11",
         [](ViewerState& s) { s.ask(Request::Kind::Picture, freeName(".png")); }, true},
        {"Picture as glint render writes it (EXR)", "F10",
         [](ViewerState& s) { s.ask(Request::Kind::Picture, freeName(".exr")); }, true},
        {"Capture a frame with RenderDoc", "F9", [](ViewerState& s) { s.ask(Request::Kind::Capture); }, true},
        {"Reload the shaders that have changed", "F5", [](ViewerState& s) { s.ask(Request::Kind::ReloadShaders); },
         true},
        {"Reload all shaders", "Shift+F5", [](ViewerState& s) { s.ask(Request::Kind::ReloadShaders, "all"); }, true},
        {"Save settings and camera", "Ctrl+S", [](ViewerState& s) { s.ask(Request::Kind::Save, s.fileText); }},
        {"Save the changes of the materials", "",
         [](ViewerState& s) { s.ask(Request::Kind::SaveMaterials, s.materials.file); }},
        {"Open a file, or what was opened lately", "Ctrl+O", toggleOpenPanel, true},
        {"Copy as command line", "Ctrl+L", [](ViewerState& s) { s.ask(Request::Kind::CopyCommandLine); }},
        {"Copy the asked ray as JSON", "Ctrl+J", [](ViewerState& s) { s.ask(Request::Kind::CopyRay); }},
        {"Close the window", "Ctrl+Q", [](ViewerState& s) { s.ask(Request::Kind::Close); }},
    };
    for (const render::ViewInfo& info : render::viewList())
        list.push_back({"View: " + std::string(info.name), "",
                        [name = std::string(info.name)](ViewerState& s) { s.view = name; }});
    for (const std::string_view preset : presetNames())
        list.push_back({"Preset: " + std::string(preset), "", [name = std::string(preset)](ViewerState& s) {
                            if (auto used = s.settings.usePreset(name); !used)
                                s.say(used.error().message, true);
                        }});
    return list;
}

} // namespace

const std::vector<ViewCommand>& viewCommands() {
    static const std::vector<ViewCommand> commands = makeCommands();
    return commands;
}

bool runShortcut(const InputEvent& event, ViewerState& state, bool typing) {
    for (const ViewCommand& command : viewCommands()) {
        if (command.keys.empty() || (typing && !command.whileTyping))
            continue;
        const Result<KeyStroke> stroke = readKeyStroke(command.keys);
        if (!stroke || stroke->key != event.key || stroke->modifiers != event.modifiers)
            continue;
        if (!event.repeated)
            command.run(state);
        return true;
    }
    return false;
}

} // namespace glint::view
