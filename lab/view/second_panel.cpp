// The inspected ray in the world, seen by a second camera: a pane with the window's own mouse controls.
#include "lab/cli/inspect/inspect_overlay.hpp"
#include "lab/view/gui_renderer.hpp"
#include "lab/view/panels.hpp"
#include "lab/view/picture_pair.hpp"
#include "lab/view/ray_lines.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

constexpr float kTurn = 3;       ///< radians for a drag over the pane's height
constexpr float kNear = 0.01f;   ///< metres along the view axis; nearer parts are not drawn
constexpr float kPiece = 5;      ///< pixels of a line per occlusion test
constexpr int kMostPieces = 512; ///< per line
constexpr ImU32 kBlack = IM_COL32(0, 0, 0, 170);

ImU32 color(std::string_view decision) {
    const Float3 c = cli::decisionColor(decision);
    return IM_COL32(static_cast<int>(c[0] * 255), static_cast<int>(c[1] * 255), static_cast<int>(c[2] * 255), 255);
}

/// For marks behind a surface; such lines are also dashed.
ImU32 faint(ImU32 color) {
    return (color & ~IM_COL32_A_MASK) | (IM_COL32(0, 0, 0, 110) & IM_COL32_A_MASK);
}

class Pane {
public:
    Pane(const SecondCamera& second, ImVec2 origin, ImVec2 size)
        : second_(second), origin_(origin.x, origin.y),
          scale_(glm::vec2(size.x, size.y) / glm::vec2(second.view.width, second.view.height)),
          list_(*ImGui::GetWindowDrawList()) {}

    void line(const RayLine& line) {
        glm::vec3 from = line.fromWS, to = line.toWS;
        if (!clipToNear(second_.view, kNear, from, to))
            return;
        const float pixels = glm::distance(seenFrom(second_.view, from).px, seenFrom(second_.view, to).px);
        const int pieces = std::clamp(static_cast<int>(pixels / kPiece), 1, kMostPieces);
        for (int i = 0; i < pieces; ++i) {
            const auto at = [&](float share) {
                return seenFrom(second_.view,
                                from + (to - from) * ((static_cast<float>(i) + share) / static_cast<float>(pieces)));
            };
            const Seen a = at(0), b = at(1), middle = at(0.5f);
            const bool hidden = second_.hides(middle.px, middle.depth);
            if (hidden && i % 2 == 1)
                continue;
            stroke(a.px, b.px, line.kind, hidden);
        }
    }

    void point(const RayPoint& point) {
        const Seen seen = seenFrom(second_.view, point.positionWS);
        if (seen.depth < kNear)
            return;
        const bool hidden = second_.hides(seen.px, seen.depth);
        const auto shade = [&](ImU32 c) { return hidden ? faint(c) : c; };
        const ImVec2 p = place(seen.px);
        switch (point.kind) {
        case RayPoint::Kind::Sample:
            list_.AddCircleFilled(p, 3.2f, shade(kBlack));
            list_.AddCircleFilled(p, 2.4f, shade(color(point.decision)));
            break;
        case RayPoint::Kind::Start:
            list_.AddNgonFilled(p, 7, shade(kBlack), 4);
            list_.AddNgonFilled(p, 5, shade(IM_COL32_WHITE), 4);
            break;
        case RayPoint::Kind::Answer:
            list_.AddCircle(p, 7, shade(kBlack), 0, 4);
            list_.AddCircle(p, 7, shade(color(point.decision)), 0, 2);
            break;
        case RayPoint::Kind::Nothing:
            for (const auto& [c, width] : {std::pair(kBlack, 4.0f), std::pair(IM_COL32(242, 51, 38, 255), 2.0f)}) {
                list_.AddLine({p.x - 6, p.y - 6}, {p.x + 6, p.y + 6}, shade(c), width);
                list_.AddLine({p.x - 6, p.y + 6}, {p.x + 6, p.y - 6}, shade(c), width);
            }
            break;
        }
    }

private:
    ImVec2 place(glm::vec2 px) const {
        const glm::vec2 p = origin_ + px * scale_;
        return {p.x, p.y};
    }
    void stroke(glm::vec2 a, glm::vec2 b, RayLine::Kind kind, bool hidden) {
        const auto shade = [&](ImU32 c) { return hidden ? faint(c) : c; };
        switch (kind) {
        case RayLine::Kind::Ray:
            list_.AddLine(place(a), place(b), shade(kBlack), 3.5f);
            list_.AddLine(place(a), place(b), shade(IM_COL32_WHITE), 1.5f);
            break;
        case RayLine::Kind::Sight: list_.AddLine(place(a), place(b), shade(IM_COL32(255, 225, 90, 255)), 1.5f); break;
        case RayLine::Kind::Frustum: list_.AddLine(place(a), place(b), shade(IM_COL32(120, 230, 140, 255)), 1); break;
        case RayLine::Kind::Gap: list_.AddLine(place(a), place(b), shade(IM_COL32(200, 200, 200, 150)), 1); break;
        }
    }

    const SecondCamera& second_;
    glm::vec2 origin_;
    glm::vec2 scale_;
    ImDrawList& list_;
};

/// The same mouse controls as in the window (InputHandler).
void move(SecondCamera& second, float height) {
    OrbitCamera& camera = second.camera;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 step = glm::vec2(io.MouseDelta.x, io.MouseDelta.y) / std::max(height, 1.0f);
    if (ImGui::IsItemActive() && step != glm::vec2(0)) {
        second.turned = true;
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
            camera.orbit(step.x * kTurn, -step.y * kTurn);
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right))
            camera.pan(-step.x, step.y);
        else
            camera.look(step.x * kTurn / 2, -step.y * kTurn / 2);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        second.turned = true;
        camera.dolly(std::pow(0.9f, io.MouseWheel));
    }
}

void pane(ViewerState& state, ImVec2 size) {
    SecondCamera& second = state.second;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("pane", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    move(second, size.y);
    second.size = glm::uvec2(static_cast<uint32_t>(size.x), static_cast<uint32_t>(size.y));
    if (second.depth.empty()) // no picture yet
        return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = {origin.x + size.x, origin.y + size.y};
    list.PushClipRect(origin, end, true);
    list.AddImage(reinterpret_cast<ImTextureID>(uintptr_t{GuiRenderer::smooth(PicturePair::kSecondCamera)}), origin,
                  end);
    if (state.asked && state.ray) {
        Pane drawn(second, origin, size);
        const RayLines lines = rayLines(*state.ray, state.rayView);
        for (const RayLine& line : lines.lines)
            drawn.line(line);
        for (const RayPoint& point : lines.points)
            drawn.point(point);
    }
    list.PopClipRect();
}

} // namespace

void drawSecondPanel(ViewerState& state) {
    SecondCamera& second = state.second;
    second.size = glm::uvec2(0);
    if (!second.shown)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x, window.y}, placing(state), {1, 1});
    ImGui::SetNextWindowSize({window.x * 0.45f, window.y * 0.5f}, placing(state));
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Second camera", &second.shown, kFlags)) {
        if (state.asked && state.ray) {
            if (ImGui::SmallButton("look at the ray"))
                second.placed = false;
            ImGui::SameLine();
        } else {
            ImGui::TextDisabled("click a pixel: its ray is drawn here");
            ImGui::SameLine();
        }
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
        ImGui::SliderFloat("cut", &second.cut, 0, second.camera.distance() * 2, "%.2f m", ImGuiSliderFlags_Logarithmic);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("takes away what is nearer than this, as a wall in between");
        const ImVec2 size = ImGui::GetContentRegionAvail();
        if (size.x >= 8 && size.y >= 8)
            pane(state, size);
    }
    ImGui::End();
}

} // namespace glint::view
