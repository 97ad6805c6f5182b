// Each pass's GPU time, frame by frame: stacked, newest to the right.
#include "lab/view/panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

/// A colour per pass, far from its neighbours': hues step by the golden ratio.
ImU32 passColor(size_t index) {
    const float hue = std::fmod(static_cast<float>(index) * 0.618034f, 1.0f);
    float r = 0, g = 0, b = 0;
    ImGui::ColorConvertHSVtoRGB(hue, 0.6f, 0.9f, r, g, b);
    return ImGui::ColorConvertFloat4ToU32({r, g, b, 1});
}

double total(const std::vector<std::pair<std::string, double>>& frame) {
    double sum = 0;
    for (const auto& [name, milliseconds] : frame)
        sum += milliseconds;
    return sum;
}

void graph(const TimeHistory& history, const std::vector<std::string>& passes, ImVec2 size) {
    double most = 0;
    for (size_t i = 0; i < history.frames(); ++i)
        most = std::max(most, total(history.frame(i)));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, IM_COL32(0, 0, 0, 120));
    const float step = size.x / static_cast<float>(TimeHistory::kFrames);
    const float scale = most > 0 ? size.y / static_cast<float>(most * 1.05) : 0;
    for (size_t i = 0; i < history.frames(); ++i) {
        const float right = low.x + size.x - step * static_cast<float>(history.frames() - 1 - i);
        float y = low.y + size.y;
        for (const auto& [name, milliseconds] : history.frame(i)) {
            const auto index = static_cast<size_t>(std::ranges::find(passes, name) - passes.begin());
            const float height = static_cast<float>(milliseconds) * scale;
            list.AddRectFilled({right - step, y - height}, {right, y}, passColor(index));
            y -= height;
        }
    }
    ImGui::Dummy(size);
    ImGui::TextDisabled("highest: %s", millisecondsText(most).c_str());
}

} // namespace

void drawTimesPanel(ViewerState& state) {
    if (!state.showTimes)
        return;
    const float em = ImGui::GetFontSize();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x, window.y}, placing(state), {1, 1});
    if (ImGui::Begin("GPU times", &state.showTimes,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing) &&
        state.history.frames() > 0) {
        const std::vector<std::string> passes = state.history.passes();
        graph(state.history, passes, {em * 24, em * 7});
        const auto& newest = state.history.frame(state.history.frames() - 1);
        if (ImGui::BeginTable("passes", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (size_t i = 0; i < newest.size(); ++i) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(passColor(i)), "%s", newest[i].first.c_str());
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(millisecondsText(newest[i].second).c_str());
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

} // namespace glint::view
