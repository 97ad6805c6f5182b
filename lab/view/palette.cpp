// The command palette: search, or browse pages.
#include "lab/view/palette_entries.hpp"
#include "lab/view/panels.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace glint::view {
namespace {

void drawEntry(ViewerState& state, const PaletteEntry& entry, bool chosen, bool run) {
    if (entry.setting) {
        ImGui::PushStyleColor(ImGuiCol_Text, chosen ? ImVec4(1, 1, 0.6f, 1) : ImVec4(0.75f, 0.8f, 0.9f, 1));
        ImGui::TextUnformatted(entry.name.c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine(ImGui::GetFontSize() * 14);
        drawSetting(state, *entry.setting, ImGui::GetFontSize() * 8);
        if (run && entry.setting->type == SettingType::Boolean)
            state.settings.set(*entry.setting, state.settings.value(*entry.setting) != 0 ? 0 : 1);
        return;
    }
    const bool clicked = ImGui::Selectable(entry.name.c_str(), chosen);
    if (!entry.command->keys.empty()) {
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::GetFontSize() * 5);
        ImGui::TextDisabled("%s", entry.command->keys.c_str());
    }
    if (clicked || run) {
        state.showPalette = false;
        entry.command->run(state);
    }
}

void pageTabs(ViewerState& state) {
    const auto& pages = palettePages();
    for (size_t i = 0; i < pages.size(); ++i) {
        const std::string label = fmt::format("{} {}", i + 1, pages[i].title);
        if (i > 0 && ImGui::GetItemRectMax().x + ImGui::CalcTextSize(label.c_str()).x + 3 * ImGui::GetFontSize() <
                         ImGui::GetWindowPos().x + ImGui::GetWindowSize().x)
            ImGui::SameLine();
        const bool now = state.palettePage == static_cast<int>(i);
        if (now)
            ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (ImGui::SmallButton(label.c_str())) {
            state.palettePage = static_cast<int>(i);
            state.paletteText.clear();
        }
        if (now)
            ImGui::PopStyleColor();
    }
}

/// Wraps lines as needed: on a software driver the figures have more digits.
void figuresLine(const ViewerState& state) {
    const FrameFigures& f = state.figures;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float space = ImGui::GetFontSize();
    bool first = true;
    for (const auto& [name, ms] :
         {std::pair("GPU Compute", f.computeMs), {"Render", f.renderMs}, {"Total", f.totalMs}, {"CPU", f.cpuMs}}) {
        const std::string text = fmt::format("{} {} ({:.0f} %)", name, millisecondsText(ms), 100 * f.load(ms));
        if (!first && ImGui::GetItemRectMax().x + space + ImGui::CalcTextSize(text.c_str()).x <= right)
            ImGui::SameLine(0, space);
        ImGui::TextDisabled("%s", text.c_str());
        first = false;
    }
}

} // namespace

bool keyPressed(int key) {
#if IMGUI_VERSION_NUM < 18700
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#else
    return ImGui::IsKeyPressed(static_cast<ImGuiKey>(key));
#endif
}

void drawPalette(ViewerState& state) {
    if (!state.showPalette)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({window.x / 2, std::min(em * 4, window.y / 8)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(em * 42, window.x), std::min(em * 28, window.y * 0.8f)});
    if (state.paletteOpens)
        ImGui::SetNextWindowFocus();
    ImGui::Begin("##palette", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    if (std::exchange(state.paletteOpens, false)) {
        state.paletteText.clear();
        state.paletteChoice = 0;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##text", "type a command or a setting; PageUp, PageDown: pages", &state.paletteText))
        state.paletteChoice = 0;
    figuresLine(state);
    const int pageCount = static_cast<int>(palettePages().size());
    if (keyPressed(ImGuiKey_PageDown))
        state.palettePage = (state.palettePage + 1) % pageCount;
    if (keyPressed(ImGuiKey_PageUp))
        state.palettePage = (state.palettePage + pageCount - 1) % pageCount;
    if (state.paletteText.empty())
        pageTabs(state);
    const std::vector<PaletteEntry> entries = state.paletteText.empty()
                                                  ? palettePages()[static_cast<size_t>(state.palettePage)].entries
                                                  : searchPalette(state.paletteText);
    const int count = static_cast<int>(entries.size());
    if (keyPressed(ImGuiKey_DownArrow))
        ++state.paletteChoice;
    if (keyPressed(ImGuiKey_UpArrow))
        --state.paletteChoice;
    state.paletteChoice = std::clamp(state.paletteChoice, 0, std::max(count - 1, 0));
    const bool enter = keyPressed(ImGuiKey_Enter);
    ImGui::BeginChild("entries");
    for (int i = 0; i < count; ++i) {
        ImGui::PushID(i);
        drawEntry(state, entries[static_cast<size_t>(i)], i == state.paletteChoice, enter && i == state.paletteChoice);
        ImGui::PopID();
    }
    if (entries.empty())
        ImGui::TextDisabled("nothing is called so");
    ImGui::EndChild();
    ImGui::End();
}

} // namespace glint::view
