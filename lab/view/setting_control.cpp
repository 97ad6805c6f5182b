// The control for one setting, created from its row in the table.
#include "lab/view/panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

std::string aliasText(const SettingInfo& info) {
    std::string text;
    for (const SettingAlias& alias : info.aliases)
        text += (text.empty() ? "" : ", ") + alias.system + ":" + alias.name;
    return text;
}

void tooltip(const ViewerState& state, const SettingInfo& info) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
    ImGui::TextUnformatted(info.key.c_str());
    ImGui::TextWrapped("%s", info.meaning.c_str());
    if (!info.range.text.empty())
        ImGui::TextDisabled("%s %s", info.range.text.c_str(), info.unit.c_str());
    ImGui::TextDisabled("without changes: %s", settingText(info, state.settings.baseline(info)).c_str());
    if (const std::string aliases = aliasText(info); !aliases.empty())
        ImGui::TextDisabled("also %s", aliases.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// Wide ranges are logarithmic, with 0 as the lower end if it is included.
ImGuiSliderFlags sliderFlags(const SettingInfo& info) {
    const bool wide = info.range.min >= 0 && info.range.max > 100 * std::max(info.range.min, 1.0);
    return ImGuiSliderFlags_NoRoundToFormat | (wide ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

void slider(ViewerState& state, const SettingInfo& info) {
    const double value = state.settings.value(info);
    double next = value;
    bool edited = false;
    if (info.type == SettingType::Int) {
        int number = static_cast<int>(value);
        edited =
            ImGui::SliderInt("##value", &number, static_cast<int>(info.range.min), static_cast<int>(info.range.max),
                             "%d", sliderFlags(info) & ~ImGuiSliderFlags_NoRoundToFormat);
        next = number;
    } else {
        float number = static_cast<float>(value);
        // The text as in settings files, with exactly the digits needed.
        const std::string text =
            settingText(info, value) + (info.unit == "m" || info.unit == "px" ? " " + info.unit : "");
        edited = ImGui::SliderFloat("##value", &number, static_cast<float>(info.range.min),
                                    static_cast<float>(std::min(info.range.max, 1e6)), text.c_str(), sliderFlags(info));
        next = static_cast<double>(number);
        if (edited && !ImGui::GetIO().WantTextInput) { // a drag sets three digits
            const double unit = next == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(next))) - 2);
            next = std::round(next / unit) * unit;
        }
    }
    static const SettingInfo* dragged = nullptr;
    if (edited) {
        state.settings.set(info, next, dragged == &info);
        dragged = &info;
    }
    if (ImGui::IsItemDeactivated())
        dragged = nullptr;
}

} // namespace

void drawSetting(ViewerState& state, const SettingInfo& info, float width) {
    ImGui::PushID(info.key.c_str());
    const bool changed = state.settings.changed(info);
    ImGui::SetNextItemWidth(width);
    if (info.type == SettingType::Boolean) {
        bool on = state.settings.value(info) != 0;
        if (ImGui::Checkbox("##value", &on))
            state.settings.set(info, on ? 1 : 0);
    } else if (info.type == SettingType::Enum) {
        const auto now = static_cast<size_t>(state.settings.value(info));
        if (ImGui::BeginCombo("##value", info.choices[now].c_str())) {
            for (size_t i = 0; i < info.choices.size(); ++i)
                if (ImGui::Selectable(info.choices[i].c_str(), i == now))
                    state.settings.set(info, static_cast<double>(i));
            ImGui::EndCombo();
        }
    } else {
        slider(state, info);
    }
    if (ImGui::IsItemHovered())
        tooltip(state, info);
    if (changed) {
        ImGui::SameLine();
        if (ImGui::SmallButton("x"))
            state.settings.reset(info);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("back to %s", settingText(info, state.settings.baseline(info)).c_str());
    }
    ImGui::SameLine();
    const std::string name = info.key.substr(info.key.rfind('.') + 1);
    if (changed)
        ImGui::TextColored({1, 0.8f, 0.35f, 1}, "%s", name.c_str());
    else
        ImGui::TextUnformatted(name.c_str());
    if (ImGui::IsItemHovered())
        tooltip(state, info);
    ImGui::PopID();
}

} // namespace glint::view
