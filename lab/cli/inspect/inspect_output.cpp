#include "lab/cli/inspect/inspect_output.hpp"

#include "lab/job/program_settings.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

/// With the shortest digits that restore the float; null if not finite.
Json number(float value) {
    if (!std::isfinite(value))
        return nullptr;
    char text[32];
    const auto written = std::to_chars(std::begin(text), std::end(text), value);
    double shortest = 0;
    std::from_chars(text, written.ptr, shortest);
    return shortest;
}

template <size_t kSize>
Json numbers(const std::array<float, kSize>& values) {
    Json json = Json::array();
    for (const float value : values)
        json.push_back(number(value));
    return json;
}

Json pointJson(const RayInspection::Point& point) {
    return {{"px", numbers(point.px)},
            {"positionVS", numbers(point.positionVS)},
            {"positionWS", numbers(point.positionWS)},
            {"depth", number(point.depth)}};
}

Json surfaceJson(const RayInspection& inspection) {
    if (inspection.background)
        return nullptr;
    return {{"depth", number(inspection.depth)},
            {"positionWS", numbers(inspection.positionWS)},
            {"normalWS", numbers(inspection.normalWS)},
            {"f0", numbers(inspection.f0)},
            {"roughness", number(inspection.perceptualRoughness)}};
}

Json hitJson(const RayInspection& inspection) {
    Json fades = Json::object();
    for (const RayInspection::Fade& fade : inspection.fades)
        fades[std::string(fade.name)] = number(fade.factor);
    return {{"pixel", *inspection.hitPixel},
            {"depth", number(inspection.hitDepth)},
            {"radiance", numbers(inspection.radiance)},
            {"weight", number(inspection.weight)},
            {"fades", std::move(fades)}};
}

Json projectionJson(const RayInspection::Projection& projection) {
    return {{"probe", projection.probe ? Json(*projection.probe) : Json(nullptr)},
            {"proxy", projection.proxy},
            {"distance", number(projection.distance)}};
}

Json samplesJson(const RayInspection& inspection) {
    Json samples = Json::array();
    for (const RaySample& sample : inspection.samples)
        samples.push_back({{"px", numbers(sample.positionPX)},
                           {"level", sample.level},
                           {"rayDepth", number(sample.rayDepth)},
                           {"sceneDepth", number(sample.sceneDepth)},
                           {"slabEndDepth", sample.slabEndDepth ? number(*sample.slabEndDepth) : Json(nullptr)},
                           {"distance", number(sample.distance)},
                           {"decision", sample.decision}});
    return samples;
}

Json rayJson(const RayInspection& inspection) {
    Json json;
    json["pixel"] = inspection.rayPixel;
    json["start"] = pointJson(inspection.start);
    json["end"] = pointJson(inspection.end);
    json["directionVS"] = numbers(inspection.directionVS);
    json["directionWS"] = numbers(inspection.directionWS);
    if (inspection.projection)
        json["projection"] = projectionJson(*inspection.projection);
    json["length"] = number(inspection.length);
    json["maxLength"] = number(inspection.maxLength);
    json["lookups"] = inspection.lookups;
    json["iterations"] = inspection.iterations;
    json["answer"] = inspection.answered ? hitJson(inspection) : Json(nullptr);
    json["samples"] = samplesJson(inspection);
    json["truncated"] = inspection.truncated;
    json["sameAsFrame"] = inspection.sameAsFrame;
    return json;
}

Json sourcesJson(const RayInspection& inspection) {
    Json sources = Json::array();
    for (const RayInspection::Source& source : inspection.sources)
        sources.push_back(
            {{"name", source.name}, {"weight", number(source.weight)}, {"radiance", numbers(source.radiance)}});
    return sources;
}

constexpr size_t kLineWidth = 180;

/// A value that fits on one line is written on one: a sample, a point.
void write(const Json& json, size_t indent, std::string& out) {
    // Names come from the command line, where bytes need not be UTF-8.
    const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool expand = json.is_structured() && !json.empty() && indent + line.size() > kLineWidth;
    if (!expand && indent > 0) {
        out += line;
        return;
    }
    out += json.is_object() ? '{' : '[';
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        out += fmt::format("{}\n{:{}}", first ? "" : ",", "", indent + 2);
        if (json.is_object())
            out += fmt::format("{}: ", Json(key).dump());
        write(value, indent + 2, out);
        first = false;
    }
    out += fmt::format("\n{:{}}{}", "", indent, json.is_object() ? '}' : ']');
}

} // namespace

std::string inspectionJson(const render::RenderJob& job, const render::RenderResult& result) {
    const RayInspection& inspection = *result.inspection;
    Json json;
    json["scene"] = job.scene;
    json["width"] = result.width;
    json["height"] = result.height;
    json["march"] = Json::parse(render::settingsJson(job.settings))["screen"]["march"];
    json["pixel"] = inspection.pixel;
    json["surface"] = surfaceJson(inspection);
    json["outcome"] = inspection.outcome;
    json["hitSuccess"] = inspection.hit;
    if (!inspection.traced)
        json["whyNoRay"] = inspection.whyNoRay;
    json["ray"] = inspection.traced ? rayJson(inspection) : Json(nullptr);
    json["sources"] = sourcesJson(inspection);
    json["totalWeight"] = number(inspection.totalWeight);
    json["reflected"] = numbers(inspection.reflected);
    json["composite"] = numbers(inspection.composite);
    json["notes"] = result.notes;
    std::string text;
    write(json, 0, text);
    return text + "\n";
}

} // namespace glint::cli
