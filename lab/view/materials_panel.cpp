// The materials of the scene: choose one by name or by a click on a surface, change it, save the changes.
#include "lab/view/panels.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace glint::view {
namespace {

constexpr float kWidestSlider = 100; ///< larger values are typed

void materialList(MaterialsModel& model) {
    const std::string now = model.chosen ? model.name(*model.chosen) : "choose, or click a surface";
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##material", now.c_str(), ImGuiComboFlags_HeightLarge))
        return;
    for (size_t i = 0; i < model.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string text = model.name(i) + (model.changed(i) ? " *" : "");
        if (ImGui::Selectable(text.c_str(), model.chosen == i))
            model.chosen = i;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void kindList(MaterialsModel& model, size_t material, float width) {
    const auto now = static_cast<size_t>(model.kind(material));
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo("kind", std::string(scene::kMaterialKindNames[now]).c_str()))
        return;
    for (size_t i = 0; i < std::size(scene::kMaterialKindNames); ++i)
        if (ImGui::Selectable(std::string(scene::kMaterialKindNames[i]).c_str(), i == now))
            model.setKind(material, static_cast<scene::MaterialKind>(i));
    ImGui::EndCombo();
}

/// Returns true if the user has changed `value`.
bool editValue(const scene::MaterialField& field, scene::FieldValue& value) {
    switch (field.type) {
    case scene::FieldType::Switch: {
        bool on = value.x != 0;
        const bool edited = ImGui::Checkbox("##value", &on);
        value = scene::FieldValue(on);
        return edited;
    }
    case scene::FieldType::Choice: {
        const auto now = static_cast<size_t>(value.x);
        bool edited = false;
        if (ImGui::BeginCombo("##value", std::string(field.choices[now]).c_str())) {
            for (size_t i = 0; i < field.choices.size(); ++i)
                if (ImGui::Selectable(std::string(field.choices[i]).c_str(), i == now)) {
                    value = scene::FieldValue(static_cast<float>(i));
                    edited = true;
                }
            ImGui::EndCombo();
        }
        return edited;
    }
    case scene::FieldType::Color:
        return ImGui::ColorEdit3("##value", &value.x,
                                 ImGuiColorEditFlags_Float |
                                     (field.max > 1 ? ImGuiColorEditFlags_HDR : ImGuiColorEditFlags_None));
    case scene::FieldType::Number: break;
    }
    return ImGui::SliderFloat("##value", &value.x, std::max(field.min, -kWidestSlider),
                              std::min(field.max, kWidestSlider), "%.3g",
                              field.max > 1 ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

void fieldRow(MaterialsModel& model, size_t material, size_t index, float width) {
    const scene::MaterialField& field = scene::materialFields()[index];
    ImGui::PushID(static_cast<int>(index));
    ImGui::SetNextItemWidth(width);
    scene::FieldValue value = model.value(material, index);
    if (editValue(field, value)) // typed values may lie outside the slider
        model.set(material, index,
                  field.type == scene::FieldType::Number || field.type == scene::FieldType::Color
                      ? glm::clamp(value, field.min, field.max)
                      : value);
    const bool changed = model.changed(material, index);
    if (changed) {
        ImGui::SameLine();
        if (ImGui::SmallButton("x"))
            model.reset(material, index);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("as in the scene's file");
    }
    ImGui::SameLine();
    const std::string name(field.name);
    if (changed)
        ImGui::TextColored({1, 0.8f, 0.35f, 1}, "%s", name.c_str());
    else
        ImGui::TextUnformatted(name.c_str());
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", std::string(field.meaning).c_str());
    ImGui::PopID();
}

void savedAs(ViewerState& state) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 12);
    ImGui::InputText("##file", &state.materials.file);
    ImGui::SameLine();
    if (ImGui::Button("save"))
        state.ask(Request::Kind::SaveMaterials, state.materials.file);
    if (state.materials.unsaved()) {
        ImGui::SameLine();
        ImGui::TextDisabled("not saved");
    }
}

} // namespace

void drawMaterialsPanel(ViewerState& state) {
    if (!state.showMaterials)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), top = ImGui::GetFrameHeight() + em;
    const float left = state.showSettings ? std::min(em * 25, window.x / 2) : 0; // the pixel's panel is on the right
    ImGui::SetNextWindowPos({left, top}, placing(state));
    ImGui::SetNextWindowSize({std::min(em * 24, window.x), std::max(window.y - top, em * 4)}, placing(state));
    if (ImGui::Begin("Materials", &state.showMaterials, ImGuiWindowFlags_NoFocusOnAppearing)) {
        MaterialsModel& model = state.materials;
        savedAs(state);
        materialList(model);
        if (model.chosen) {
            const size_t material = *model.chosen;
            const float width = em * 11;
            kindList(model, material, width);
            if (model.changed(material)) {
                ImGui::SameLine();
                if (ImGui::SmallButton("reset all"))
                    model.reset(material);
            }
            ImGui::Separator();
            for (size_t i = 0; i < scene::materialFields().size(); ++i)
                if (model.has(material, scene::materialFields()[i]))
                    fieldRow(model, material, i, width);
        }
    }
    ImGui::End();
}

} // namespace glint::view
