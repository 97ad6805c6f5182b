#include "lab/cli/render/render_output.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/compare/exact_report.hpp"
#include "lab/cli/compare/hits_report.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/session/views.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

} // namespace

Result<std::vector<uint8_t>> displayedBytes(const render::RenderedView& view) {
    GLINT_TRY(info, render::findView(view.name));
    return info->kind == render::ViewKind::Radiance ? view.rgb8 : render::displayBytes(info->kind, view.rgba);
}

namespace {

Result<void> writePngs(const std::string& path, const render::RenderResult& result) {
    for (const render::RenderedView& view : result.views) {
        GLINT_TRY(rgb, displayedBytes(view));
        const bool first = &view == &result.views.front();
        GLINT_CHECK(scene::writePng(first ? path : pathForView(path, view.name), result.width, result.height, 3, rgb));
    }
    return {};
}

} // namespace

Result<std::vector<scene::ExrLayer>> pictureLayers(const render::RenderResult& result) {
    std::vector<scene::ExrLayer> layers;
    for (const render::RenderedView& view : result.views) {
        GLINT_TRY(info, render::findView(view.name));
        scene::ExrLayer layer;
        layer.name = layers.empty() ? "" : view.name;
        layer.channels = info->channels;
        layer.half = info->kind == render::ViewKind::Radiance; // as the frame computes it; other values keep all bits
        layer.pixels = view.rgba;
        layers.push_back(std::move(layer));
    }
    return layers;
}

Result<PictureKind> pictureKind(std::string_view path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".png")
        return PictureKind::Png;
    if (ending == ".exr")
        return PictureKind::Exr;
    if (namesStream(std::string(path)))
        return PictureKind::Png;
    return invalidArgument("-o {}: the name must end in .png or .exr", printable(path));
}

std::string pathForView(const std::string& path, std::string_view view) {
    if (namesStream(path))
        return path;
    std::filesystem::path named(path);
    const std::string ending = named.extension().string();
    std::string part(view);
    std::ranges::replace_if(
        part, [](char c) { return c == '/' || c == ':'; }, '-'); // from "pass:image"
    return named.replace_extension().string() + "." + part + ending;
}

Result<void> writePictures(const std::string& path, const render::RenderResult& result) {
    GLINT_TRY(kind, pictureKind(path));
    if (kind == PictureKind::Png)
        return writePngs(path, result);
    GLINT_TRY(layers, pictureLayers(result));
    return scene::writeExr(path, result.width, result.height, layers);
}

nlohmann::ordered_json sceneRaysJson(const Statistics::SceneRays& scene) {
    return {{"pixels", scene.pixels},
            {"rays", scene.rays},
            {"fromScreen", scene.fromScreen},
            {"replaced", scene.replaced},
            {"reusedLight", scene.reusedLight}};
}

namespace {

Json memoryJson(const MemoryReport& memory) {
    Json uses = Json::array();
    for (const MemoryUse& use : memory.uses)
        uses.push_back({{"name", use.name}, {"bytes", use.bytes}, {"count", use.count}});
    return {{"bytes", memory.bytes}, {"taken", memory.taken}, {"uses", std::move(uses)}};
}

} // namespace

std::string statsJson(const render::RenderJob& job, const render::RenderResult& result, const Measured& measured) {
    const render::RenderStats& stats = result.stats;
    Json json;
    json["scene"] = job.scene;
    json["device"] = {{"name", stats.device}, {"driver", stats.driver}, {"software", stats.software}};
    json["width"] = result.width;
    json["height"] = result.height;
    json["frames"] = result.settled ? result.settled->frames : job.frames;
    if (result.settled && std::isfinite(result.settled->error))
        json["settleError"] = result.settled->error;
    json["time"] = job.time;
    json["seed"] = job.seed;
    double total = 0;
    Json passes = Json::array();
    for (const auto& [name, milliseconds] : stats.passes) {
        passes.push_back({{"name", name}, {"ms", milliseconds}});
        total += milliseconds;
    }
    if (!stats.passes.empty())
        json["gpuMs"] = total;
    json["passes"] = std::move(passes);
    Json plan = Json::object();
    for (const FrameDecision& decision : stats.plan)
        plan[decision.name] = decision.value;
    json["plan"] = std::move(plan);
    json["memory"] = memoryJson(stats.memory);
    json["rays"] = stats.rays;
    json["lookupsPerRay"] = stats.lookupsPerRay;
    json["lookups95"] = stats.lookups95;
    if (job.settings.reflections.rays.enabled)
        json["sceneRays"] = sceneRaysJson(stats.scene);
    Json outcomes = Json::object();
    for (const auto& [name, pixels] : stats.outcomes)
        outcomes[name] = pixels;
    json["outcomes"] = std::move(outcomes);
    if (measured.exact)
        json["exact"] = exactJson(*measured.exact);
    if (measured.hits)
        json["hits"] = hitReportJson(*measured.hits, stats.outcomes);
    json["notes"] = result.notes;
    json["preset"] = job.settings.preset;
    json["settings"] = Json::parse(render::settingsJson(job.settings));
    // Names come from drivers and from the command line, where bytes need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace glint::cli
