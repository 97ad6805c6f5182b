// All settings from the table: groups, search, presets, files.
#include "lab/view/panels.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace glint::view {
namespace {

void presets(ViewerState& state) {
    const std::string now = state.settings.settings().preset;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
    if (!ImGui::BeginCombo("preset", now.c_str()))
        return;
    for (const std::string_view name : presetNames())
        if (ImGui::Selectable(std::string(name).c_str(), name == now))
            if (auto used = state.settings.usePreset(name); !used)
                state.say(used.error().message, true);
    ImGui::EndCombo();
}

void files(ViewerState& state) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 10);
    ImGui::InputText("##file", &state.fileText);
    ImGui::SameLine();
    if (ImGui::Button("save"))
        state.ask(Request::Kind::Save, state.fileText);
    ImGui::SameLine();
    if (ImGui::Button("open"))
        state.ask(Request::Kind::Open, state.fileText);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("settings or a camera (.json), a scene (.glb, .gltf), an environment (.hdr, .exr)");
    ImGui::SameLine();
    if (ImGui::Button("copy"))
        state.ask(Request::Kind::CopyCommandLine);
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("copy as command line: the `glint render` that makes this picture");
}

void history(ViewerState& state) {
    if (ImGui::Button("undo"))
        state.settings.undo();
    ImGui::SameLine();
    if (ImGui::Button("redo"))
        state.settings.redo();
    ImGui::SameLine();
    if (ImGui::Button(fmt::format("reset {}", state.settings.changedCount()).c_str()))
        state.settings.resetAll();
}

void groups(ViewerState& state, float width) {
    std::string open; // the previous row's group
    bool shown = false;
    for (const SettingInfo* info : state.settings.search({})) {
        const std::string group = info->key.substr(0, info->key.rfind('.'));
        if (group != open) {
            open = group;
            size_t changed = 0;
            for (const SettingInfo* other : state.settings.search({}))
                changed += other->key.substr(0, other->key.rfind('.')) == group && state.settings.changed(*other);
            const std::string title = changed > 0 ? fmt::format("{} ({} changed)###{}", group, changed, group) : group;
            shown = ImGui::CollapsingHeader(title.c_str(), group == "screen" ? ImGuiTreeNodeFlags_DefaultOpen
                                                                             : ImGuiTreeNodeFlags_None);
        }
        if (shown)
            drawSetting(state, *info, width);
    }
}

void found(ViewerState& state, float width) {
    const std::vector<const SettingInfo*> list = state.settings.search(state.settingsText);
    if (list.empty())
        ImGui::TextDisabled("no setting has such a name");
    for (const SettingInfo* info : list) {
        ImGui::TextDisabled("%s", info->key.c_str());
        drawSetting(state, *info, width);
    }
}

} // namespace

void drawSettingsPanel(ViewerState& state) {
    if (!state.showSettings)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), top = ImGui::GetFrameHeight() + em;
    ImGui::SetNextWindowPos({0, top}, placing(state));
    ImGui::SetNextWindowSize({std::min(em * 25, window.x), std::max(window.y - top, em * 4)}, placing(state));
    if (ImGui::Begin("Settings", &state.showSettings, ImGuiWindowFlags_NoFocusOnAppearing)) {
        presets(state);
        ImGui::SameLine();
        history(state);
        files(state);
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##search", "search: a name, or another system's", &state.settingsText);
        ImGui::BeginChild("list");
        const float width = em * 9;
        if (state.settingsText.empty())
            groups(state, width);
        else
            found(state, width);
        ImGui::EndChild();
    }
    ImGui::End();
}

} // namespace glint::view
