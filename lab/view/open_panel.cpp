// The panel that opens files: search by name, or browse folders.
#include "lab/view/panels.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace glint::view {
namespace {

const char* heading(OpenEntry::Kind kind) {
    switch (kind) {
    case OpenEntry::Kind::Recent: return "opened lately";
    case OpenEntry::Kind::Folder:
    case OpenEntry::Kind::File: return "in this folder";
    case OpenEntry::Kind::Builtin: return "built in";
    }
    return "";
}

void list(ViewerState& state) {
    OpenPanel& panel = state.open;
    panel.entries = openEntries(panel.folder, panel.text, state.recent.list());
    panel.listed = panel.folder + "\n" + panel.text;
    panel.choice = 0;
}

void choose(ViewerState& state, const OpenEntry& entry) {
    OpenPanel& panel = state.open;
    if (entry.kind == OpenEntry::Kind::Folder) {
        panel.folder = entry.path;
        panel.text.clear();
        panel.begins = true; // the field regains the focus
        return;
    }
    panel.shown = false;
    state.ask(Request::Kind::Open, entry.path);
}

/// Returns the entry chosen by mouse or Enter, or null.
const OpenEntry* rows(OpenPanel& panel, bool enter) {
    const OpenEntry* chosen = nullptr;
    const char* last = "";
    for (size_t i = 0; i < panel.entries.size(); ++i) {
        const OpenEntry& entry = panel.entries[i];
        if (const char* const now = heading(entry.kind); panel.text.empty() && now != last) {
            ImGui::TextDisabled("%s", now);
            last = now;
        }
        ImGui::PushID(static_cast<int>(i));
        const bool marked = panel.choice == static_cast<int>(i);
        if (ImGui::Selectable(entry.name.c_str(), marked) || (enter && marked))
            chosen = &entry;
        if (marked && panel.scroll)
            ImGui::SetScrollHereY();
        ImGui::PopID();
    }
    panel.scroll = false;
    return chosen;
}

} // namespace

void drawOpenPanel(ViewerState& state) {
    OpenPanel& panel = state.open;
    if (!panel.shown)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({window.x / 2, std::min(em * 4, window.y / 8)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(em * 42, window.x), std::min(em * 32, window.y * 0.85f)});
    if (panel.begins)
        ImGui::SetNextWindowFocus();
    ImGui::Begin("##open", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    if (panel.folder.empty()) {
        std::error_code ignored;
        panel.folder = std::filesystem::current_path(ignored).string();
    }
    if (std::exchange(panel.begins, false)) {
        panel.listed.clear(); // list again, as files may have changed
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##text", "a part of a name, or a path; Enter opens", &panel.text);
    ImGui::TextDisabled("%s", panel.folder.c_str());
    if (panel.listed != panel.folder + "\n" + panel.text)
        list(state);
    const int count = static_cast<int>(panel.entries.size());
    const int before = panel.choice;
    panel.choice += (keyPressed(ImGuiKey_DownArrow) ? 1 : 0) - (keyPressed(ImGuiKey_UpArrow) ? 1 : 0);
    panel.choice = std::clamp(panel.choice, 0, std::max(count - 1, 0));
    panel.scroll = panel.choice != before;
    ImGui::BeginChild("entries");
    const OpenEntry* const chosen = rows(panel, keyPressed(ImGuiKey_Enter));
    if (count == 0)
        ImGui::TextDisabled("nothing here can be opened: .glb .gltf .hdr .exr .json");
    ImGui::EndChild();
    ImGui::End();
    if (chosen)
        choose(state, OpenEntry(*chosen));
}

} // namespace glint::view
