// The inspected pixel in words: everything that `glint inspect` prints (docs/inspect.md).
#include "lab/view/panels.hpp"

#include "lab/cli/inspect/inspect_overlay.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace glint::view {
namespace {

std::string text(const Float3& v) {
    return fmt::format("{:.3g} {:.3g} {:.3g}", v[0], v[1], v[2]);
}

void row(const char* name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
}

bool beginRows(const char* name) {
    return ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit);
}

void surface(const RayInspection& ray) {
    if (ray.background) {
        ImGui::TextUnformatted("background: no surface");
        return;
    }
    if (!beginRows("surface"))
        return;
    row("depth", fmt::format("{:.4g} m", ray.depth));
    row("position", text(ray.positionWS));
    row("normal", text(ray.normalWS));
    row("F0", text(ray.f0));
    row("roughness", fmt::format("{:.3g}", ray.perceptualRoughness));
    ImGui::EndTable();
}

void trace(const RayInspection& ray) {
    if (!ray.traced) {
        ImGui::TextWrapped("no ray: %s", std::string(ray.whyNoRay).c_str());
        return;
    }
    const Float3 color = cli::decisionColor(ray.outcome);
    ImGui::TextColored({color[0], color[1], color[2], 1}, "outcome: %s", std::string(ray.outcome).c_str());
    if (!beginRows("ray"))
        return;
    row("hit success", ray.hit ? "yes" : "no");
    row("starts at pixel", fmt::format("{} {}", ray.rayPixel[0], ray.rayPixel[1]));
    row("start", fmt::format("px {:.1f} {:.1f}, depth {:.4g} m", ray.start.px[0], ray.start.px[1], ray.start.depth));
    row("end", fmt::format("px {:.1f} {:.1f}, depth {:.4g} m", ray.end.px[0], ray.end.px[1], ray.end.depth));
    row("end position", text(ray.end.positionWS));
    row("direction", text(ray.directionWS));
    if (ray.projection) {
        const RayInspection::Projection& to = *ray.projection;
        row("proxy", to.probe ? fmt::format("{}, of probe {}", to.proxy, *to.probe) : "none: no probe here");
        row("projection distance", std::isfinite(to.distance) ? fmt::format("{:.4g} m", to.distance) : "infinite");
    }
    row("length", fmt::format("{:.4g} of {:.4g} m", ray.length, ray.maxLength));
    if (ray.hitPixel)
        row("hit pixel", fmt::format("{} {}, depth {:.4g} m", (*ray.hitPixel)[0], (*ray.hitPixel)[1], ray.hitDepth));
    row("radiance", text(ray.radiance));
    row("weight", fmt::format("{:.4g}", ray.weight));
    for (const RayInspection::Fade& fade : ray.fades)
        row(fmt::format("  fade {}", fade.name).c_str(), fmt::format("{:.4g}", fade.factor));
    row("lookups, steps", fmt::format("{}, {}", ray.lookups, ray.iterations));
    row("same as the frame", ray.sameAsFrame ? "yes" : "NO");
    ImGui::EndTable();
}

void sources(const RayInspection& ray) {
    if (!beginRows("sources"))
        return;
    for (const RayInspection::Source& source : ray.sources)
        row(fmt::format("source {}", source.name).c_str(),
            fmt::format("weight {:.3g}, radiance {}", source.weight, text(source.radiance)));
    row("total weight", fmt::format("{:.4g}", ray.totalWeight));
    row("reflected", text(ray.reflected));
    row("composite", text({ray.composite[0], ray.composite[1], ray.composite[2]}));
    ImGui::EndTable();
}

void samples(const RayInspection& ray) {
    if (ray.samples.empty() ||
        !ImGui::CollapsingHeader(
            fmt::format("{} samples{}###samples", ray.samples.size(), ray.truncated ? ", the first ones" : "").c_str()))
        return;
    if (!ImGui::BeginTable("samples", 5, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg))
        return;
    for (const char* title : {"px", "level", "ray m", "scene m", "decision"})
        ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    for (const RaySample& sample : ray.samples) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::Text("%.1f %.1f", static_cast<double>(sample.positionPX[0]), static_cast<double>(sample.positionPX[1]));
        ImGui::TableNextColumn();
        ImGui::Text("%u", sample.level);
        ImGui::TableNextColumn();
        ImGui::Text("%.4g", static_cast<double>(sample.rayDepth));
        ImGui::TableNextColumn();
        ImGui::Text("%.4g", static_cast<double>(sample.sceneDepth));
        ImGui::TableNextColumn();
        const Float3 color = cli::decisionColor(sample.decision);
        ImGui::TextColored({color[0], color[1], color[2], 1}, "%s", std::string(sample.decision).c_str());
    }
    ImGui::EndTable();
}

} // namespace

void drawRayPanel(ViewerState& state) {
    if (!state.asked || !state.ray)
        return;
    const RayInspection& ray = *state.ray;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), top = ImGui::GetFrameHeight() + em;
    ImGui::SetNextWindowPos({window.x, top}, placing(state), {1, 0});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x, std::max(window.y - top, em * 4)});
    bool open = true;
    if (ImGui::Begin("Pixel", &open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::Text("pixel %u, %u%s", ray.pixel[0], ray.pixel[1], state.askFollows ? ", follows the mouse" : "");
        ImGui::SameLine();
        if (ImGui::SmallButton("copy JSON"))
            state.ask(Request::Kind::CopyRay);
        surface(ray);
        ImGui::Separator();
        trace(ray);
        ImGui::Separator();
        sources(ray);
        samples(ray);
    }
    ImGui::End();
    if (!open)
        state.asked.reset();
}

} // namespace glint::view
