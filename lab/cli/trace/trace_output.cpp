#include "lab/cli/trace/trace_output.hpp"

#include "lab/cli/render/render_output.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace glint::cli {
namespace {

using TraceJson = nlohmann::ordered_json;

const std::vector<float>& viewNamed(const render::RenderResult& result, std::string_view name) {
    return std::ranges::find(result.views, name, &render::RenderedView::name)->rgba;
}

bool specularIsDefined(const Settings& settings) {
    return settings.composite.model == CompositeModel::Physical && settings.reflect.strength == 1 &&
           settings.reflect.falloffExponent == 1 && !settings.debug.outcome;
}

std::span<const float> floatsOf(const std::vector<glm::vec3>& plane) {
    return {plane.empty() ? nullptr : &plane.front().x, plane.size() * 3};
}

/// The result with the job's views alone.
render::RenderResult withViewsOf(const render::TraceJob& job, const render::RenderResult& result) {
    render::RenderResult chosen = result;
    std::erase_if(chosen.views, [&](const render::RenderedView& view) {
        return std::ranges::find(job.picture.views, view.name) == job.picture.views.end();
    });
    return chosen;
}

TraceJson errorJson(const measure::ByBand<measure::SpecularError>& errors) {
    constexpr std::array<std::string_view, measure::kBands + 1> kNames = {"mirror", "glossy", "rough", "all"};
    TraceJson json = TraceJson::object();
    for (size_t band = 0; band < kNames.size(); ++band) {
        const measure::SpecularError& error = errors[band];
        if (error.pixels > 0)
            json[std::string(kNames[band])] = {
                {"pixels", error.pixels},
                {"relativeMse", error.relativeMse},
                {"psnr", std::isfinite(error.psnr) ? TraceJson(error.psnr) : TraceJson()},
                {"energy", error.energy}};
    }
    return json;
}

} // namespace

TraceFigures traceFigures(const render::TraceJob& job, const render::TraceInputs& inputs,
                          const render::RenderResult& result) {
    TraceFigures figures;
    if (!specularIsDefined(job.picture.settings.reflections))
        return figures;
    figures.specular = measure::specularLayer(viewNamed(result, "composite"), viewNamed(result, "scene"),
                                              viewNamed(result, "weights"), floatsOf(inputs.pixels->fallbackSpecular));
    if (!inputs.pixels->reference.empty())
        figures.error = measure::specularError(*figures.specular, floatsOf(inputs.pixels->reference),
                                               viewNamed(result, "roughness"), viewNamed(result, "reflectivity"));
    return figures;
}

Result<void> writeTraced(const std::string& path, const render::TraceJob& job, const render::RenderResult& result,
                         const TraceFigures& figures) {
    const render::RenderResult chosen = withViewsOf(job, result);
    GLINT_TRY(kind, pictureKind(path));
    if (kind == PictureKind::Png || !figures.specular)
        return writePictures(path, chosen);
    GLINT_TRY(layers, pictureLayers(chosen));
    layers.push_back({"specular", "RGB", true, *figures.specular});
    return scene::writeExr(path, chosen.width, chosen.height, layers);
}

std::string traceStatsJson(const render::TraceJob& job, const render::TraceInputs& inputs,
                           const render::RenderResult& result, const TraceFigures& figures) {
    TraceJson json = {{"gbuffer", job.picture.scene},
                      {"color", job.color.empty() ? job.picture.scene : job.color},
                      {"surfaces", inputs.pixels->surfaces},
                      {"check",
                       {{"testedPixels", inputs.health.tested},
                        {"normalsAgree", inputs.health.normalsAgree},
                        {"findings", inputs.health.findings}}}};
    if (figures.error)
        json["error"] = errorJson(*figures.error);
    const TraceJson common = TraceJson::parse(statsJson(job.picture, result));
    for (const auto& [key, value] : common.items())
        if (key != "scene" && key != "time")
            json[key] = value;
    return json.dump(2, ' ', false, TraceJson::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
