#include "lab/view/ray_overlay.hpp"

#include "lab/cli/inspect/inspect_overlay.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

constexpr ImU32 kBlack = IM_COL32(0, 0, 0, 160);
constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kNothing = IM_COL32(242, 51, 38, 255);

ImU32 colorOf(std::string_view decision, int alpha = 255) {
    const Float3 c = cli::decisionColor(decision);
    return IM_COL32(static_cast<int>(c[0] * 255), static_cast<int>(c[1] * 255), static_cast<int>(c[2] * 255), alpha);
}

class Marks {
public:
    Marks(const Canvas& canvas, glm::vec2 size) : canvas_(canvas), size_(size), list_(ImGui::GetBackgroundDrawList()) {}

    ImVec2 at(Float2 px) const {
        const glm::vec2 point = canvas_.toPX(glm::vec2(px[0], px[1]) / size_);
        return {point.x, point.y};
    }
    void cell(const RaySample& sample) {
        const float side = static_cast<float>(1u << sample.level);
        const Float2 low = {std::floor(sample.positionPX[0] / side) * side,
                            std::floor(sample.positionPX[1] / side) * side};
        list_->AddRect(at(low), at({low[0] + side, low[1] + side}), colorOf(sample.decision, 190));
    }
    void disc(const RaySample& sample) {
        const float radius = 2.2f + 0.5f * static_cast<float>(std::min(sample.level, 8u));
        list_->AddCircleFilled(at(sample.positionPX), radius + 1, kBlack);
        list_->AddCircleFilled(at(sample.positionPX), radius, colorOf(sample.decision));
    }
    void line(Float2 a, Float2 b) {
        list_->AddLine(at(a), at(b), kBlack, 3.5f);
        list_->AddLine(at(a), at(b), kWhite, 1.5f);
    }
    void diamond(Float2 px, ImU32 color) {
        list_->AddNgonFilled(at(px), 7, kBlack, 4);
        list_->AddNgonFilled(at(px), 5, color, 4);
    }
    void ring(Float2 px, ImU32 color) {
        list_->AddCircle(at(px), 7, kBlack, 0, 4);
        list_->AddCircle(at(px), 7, color, 0, 2);
    }
    void cross(Float2 px) {
        const ImVec2 p = at(px);
        for (const auto& [color, width] : {std::pair(kBlack, 4.0f), std::pair(kNothing, 2.0f)}) {
            list_->AddLine({p.x - 6, p.y - 6}, {p.x + 6, p.y + 6}, color, width);
            list_->AddLine({p.x - 6, p.y + 6}, {p.x + 6, p.y - 6}, color, width);
        }
    }

private:
    const Canvas& canvas_;
    glm::vec2 size_;
    ImDrawList* list_;
};

/// Clips the line from `start` to an image of this size. Returns its end.
Float2 insideEnd(Float2 start, Float2 end, glm::vec2 size) {
    float share = 1;
    for (size_t axis = 0; axis < 2; ++axis) {
        const float delta = end[axis] - start[axis];
        const float border = delta > 0 ? size[static_cast<int>(axis)] : 0;
        if (delta != 0)
            share = std::min(share, (border - start[axis]) / delta);
    }
    share = std::isfinite(share) ? std::max(share, 0.0f) : 0.0f;
    return {start[0] + (end[0] - start[0]) * share, start[1] + (end[1] - start[1]) * share};
}

} // namespace

void drawRayOverlay(const RayInspection& ray, const Canvas& canvas, glm::vec2 size) {
    Marks marks(canvas, size);
    if (!ray.traced) {
        marks.diamond({static_cast<float>(ray.pixel[0]) + 0.5f, static_cast<float>(ray.pixel[1]) + 0.5f}, kNothing);
        return;
    }
    const Float2 end = insideEnd(ray.start.px, ray.end.px, size);
    for (const RaySample& sample : ray.samples)
        if (sample.level > 0)
            marks.cell(sample);
    marks.line(ray.start.px, end);
    for (const RaySample& sample : ray.samples)
        marks.disc(sample);
    marks.diamond(ray.start.px, kWhite);
    if (ray.answered)
        marks.ring(end, colorOf(ray.outcome));
    else
        marks.cross(end);
}

} // namespace glint::view
