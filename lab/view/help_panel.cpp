// The cost of the frame, and the list of keys.
#include "lab/view/panels.hpp"
#include "lab/view/ssr_keys.hpp"
#include "lab/view/view_commands.hpp"

#include <imgui.h>

#include <algorithm>

namespace glint::view {
namespace {

void figure(const ViewerState& state, const char* name, double milliseconds) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(millisecondsText(milliseconds).c_str());
    ImGui::TableNextColumn();
    ImGui::Text("%.1f %%", 100 * state.figures.load(milliseconds));
}

void figures(const ViewerState& state) {
    if (!ImGui::BeginTable("figures", 3, ImGuiTableFlags_SizingFixedFit))
        return;
    figure(state, "GPU Compute", state.figures.computeMs);
    figure(state, "GPU Render", state.figures.renderMs);
    figure(state, "GPU Total", state.figures.totalMs);
    figure(state, "CPU", state.figures.cpuMs);
    ImGui::EndTable();
    ImGui::TextDisabled("load: of %s from frame to frame; without the copy into the window",
                        millisecondsText(state.figures.intervalMs).c_str());
}

void keyRow(const std::string& keys, const std::string& name) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", keys.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
}

void keys(const ViewerState& state) {
    if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit))
        return;
    for (const SsrKey& key : kSsrKeys) {
        const SettingInfo& info = settingOf(key.setting);
        keyRow(fmt::format("{} {}", key.less, key.more),
               fmt::format("{}: {}", key.name, settingText(info, state.settings.value(info))));
    }
    for (const ViewCommand& command : viewCommands())
        if (!command.keys.empty())
            keyRow(command.keys, command.name);
    keyRow("W A S D Q E", "Fly, with Shift faster");
    keyRow("drag", "Orbit; right: pan; middle: look around");
    keyRow("wheel", "Come closer; with Ctrl: zoom to single pixels");
    keyRow("click", "Ask the pixel why; double: turn to it");
    ImGui::EndTable();
}

} // namespace

int placing(const ViewerState& state) {
    return state.placePanels ? ImGuiCond_Always : ImGuiCond_FirstUseEver;
}

std::string millisecondsText(double milliseconds) {
    return milliseconds > 0 ? fmt::format("{:.2f} ms", milliseconds) : "-";
}

void drawHelpPanel(ViewerState& state) {
    if (!state.showHelp)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), top = ImGui::GetFrameHeight() + em;
    ImGui::SetNextWindowPos({window.x, top}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x, std::max(window.y - top, em * 4)});
    if (ImGui::Begin("Help", &state.showHelp,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        figures(state);
        ImGui::Separator();
        if (state.stats.rays > 0)
            ImGui::Text("%llu rays, %.1f lookups each, 95 %%: %u", static_cast<unsigned long long>(state.stats.rays),
                        state.stats.lookupsPerRay, state.stats.lookups95);
        for (const std::string& note : state.notes)
            ImGui::TextColored({1, 0.8f, 0.35f, 1}, "%s", note.c_str());
        ImGui::Text("%s%s", state.stats.device.c_str(), state.stats.software ? " (software)" : "");
        ImGui::Separator();
        keys(state);
    }
    ImGui::End();
}

} // namespace glint::view
