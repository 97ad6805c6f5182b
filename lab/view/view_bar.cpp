// The bar along the top: views, second picture, camera, time; and the last message.
#include "lab/session/views.hpp"
#include "lab/view/panels.hpp"

#include <imgui.h>

#include <algorithm>

namespace glint::view {
namespace {

/// Draws a label to the left of its control.
void label(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine();
}

void viewCombo(std::string& view) {
    label("view");
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    if (!ImGui::BeginCombo("##view", view.c_str()))
        return;
    for (const render::ViewInfo& info : render::viewList()) {
        const std::string name(info.name);
        if (ImGui::Selectable(name.c_str(), name == view))
            view = name;
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", std::string(info.meaning).c_str());
    }
    ImGui::EndCombo();
}

std::string besideText(const ViewerState& state) {
    switch (state.beside) {
    case Beside::Nothing: return "nothing";
    case Beside::View: return "view " + state.besideView;
    case Beside::Settings: break;
    }
    return state.besidePreset.empty() ? "march " + state.besideMarch : "preset " + state.besidePreset;
}

void besideCombo(ViewerState& state) {
    label("beside");
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 10);
    if (!ImGui::BeginCombo("##beside", besideText(state).c_str(), ImGuiComboFlags_HeightLarge))
        return;
    if (ImGui::Selectable("nothing", state.beside == Beside::Nothing)) {
        state.beside = Beside::Nothing;
        state.heat = Heat::None;
    }
    ImGui::TextDisabled("other settings");
    for (const std::string_view name : presetNames())
        if (ImGui::Selectable(("preset " + std::string(name)).c_str())) {
            state.beside = Beside::Settings;
            state.besidePreset = name;
        }
    for (const std::string& march : settingOf("screen.march").choices)
        if (ImGui::Selectable(("march " + march).c_str())) {
            state.beside = Beside::Settings;
            state.besidePreset.clear();
            state.besideMarch = march;
        }
    ImGui::TextDisabled("another view");
    for (const render::ViewInfo& info : render::viewList())
        if (ImGui::Selectable(("view " + std::string(info.name)).c_str())) {
            state.beside = Beside::View;
            state.besideView = info.name;
            state.heat = Heat::None;
        }
    ImGui::EndCombo();
}

void cameraCombo(ViewerState& state) {
    const bool own = state.cameraIndex < 0 || state.camera.moved();
    const std::string shown =
        own ? "free"
            : fmt::format("{} {}", state.cameraIndex, state.cameras[static_cast<size_t>(state.cameraIndex)].name);
    label("camera");
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    if (!ImGui::BeginCombo("##camera", shown.c_str()))
        return;
    for (size_t i = 0; i < state.cameras.size(); ++i)
        if (ImGui::Selectable(fmt::format("{} {}", i, state.cameras[i].name).c_str())) {
            state.camera = OrbitCamera(state.cameras[i], state.camera.distance());
            state.cameraIndex = static_cast<int>(i);
        }
    ImGui::EndCombo();
}

void animationControls(ViewerState& state) {
    Animation& animation = state.animation;
    if (animation.length <= 0)
        return;
    ImGui::SameLine();
    if (ImGui::Button(animation.playing ? "pause" : "play"))
        animation.playing = !animation.playing;
    ImGui::SameLine();
    float seconds = static_cast<float>(animation.seconds);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    if (ImGui::SliderFloat("s", &seconds, 0, static_cast<float>(animation.length), "%.2f")) {
        animation.seconds = static_cast<double>(seconds);
        animation.playing = false;
    }
}

} // namespace

void drawViewBar(ViewerState& state) {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({ImGui::GetIO().DisplaySize.x, 0});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::Begin("##bar", nullptr, kFlags);
    viewCombo(state.view);
    ImGui::SameLine();
    besideCombo(state);
    if (state.beside == Beside::Settings) {
        int heat = static_cast<int>(state.heat);
        ImGui::SameLine();
        label("error");
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
        if (ImGui::Combo("##error", &heat, "none\0difference\0FLIP\0"))
            state.heat = static_cast<Heat>(heat);
    }
    ImGui::SameLine();
    cameraCombo(state);
    animationControls(state);
    ImGui::SameLine();
    ImGui::TextDisabled("%ux%u, frame %u", state.width, state.height, state.frames);
    if (state.beside == Beside::Settings) {
        ImGui::SameLine();
        if (state.heat != Heat::None)
            ImGui::TextDisabled("mean error %.4f, reference %u", state.heatMean, state.besideFrames);
        else
            ImGui::TextDisabled("beside: frame %u", state.besideFrames);
    }
    ImGui::End();
}

void drawShaderError(ViewerState& state) {
    if (state.shaderError.empty())
        return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, size.y}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({size.x, 0});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("##shaders", nullptr, kFlags);
    ImGui::TextDisabled("the shaders of before are shown:");
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored({1, 0.5f, 0.4f, 1}, "%s", state.shaderError.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void drawMessage(ViewerState& state) {
    if (state.message.empty() || state.now > state.messageUntil)
        return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y - ImGui::GetFontSize()}, ImGuiCond_Always, {0.5f, 1});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                                        ImGuiWindowFlags_NoSavedSettings;
    ImGui::Begin("##message", nullptr, kFlags);
    ImGui::PushTextWrapPos(std::max(size.x - 40, 100.0f));
    if (state.messageIsError)
        ImGui::TextColored({1, 0.5f, 0.4f, 1}, "%s", state.message.c_str());
    else
        ImGui::TextUnformatted(state.message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

} // namespace glint::view
