#include "hits_report.hpp"

#include "render/job_inputs.hpp"
#include "render/view.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;
using OutcomeNames = std::vector<std::pair<std::string, uint64_t>>;

constexpr std::array<const char*, measure::kTruthKinds> kTruthNames = {"noRay",  "visibleElsewhere", "offScreen",
                                                                       "hidden", "behindCamera",     "nothing"};
constexpr std::array kBandNames = {"mirror", "glossy", "rough"};

template <size_t kCount>
Json countsJson(const std::array<uint64_t, kCount>& counts, const OutcomeNames& names) {
    Json json = Json::object();
    for (size_t i = 0; i < kCount; ++i)
        if (counts[i] > 0)
            json[i < names.size() ? names[i].first : fmt::format("outcome {}", i)] = counts[i];
    return json;
}

const std::vector<float>& viewOf(const render::RenderResult& result, std::string_view name) {
    return std::ranges::find(result.views, name, &render::RenderedView::name)->rgba;
}

} // namespace

render::ProgramSettings hitSettings(const render::ProgramSettings& settings) {
    render::ProgramSettings all = settings;
    Settings& reflections = all.reflections;
    reflections.reflect.threshold = 0;
    reflections.reflect.roughnessFadeStart = 1;
    reflections.reflect.maxRoughness = 1;
    reflections.rough.factor = 0;
    all.render.display.antialias = render::Antialias::None; // one surface a pixel
    return all;
}

std::vector<std::string> hitViews() {
    return {"depth", "normal", "reflectivity", "ray"};
}

render::RenderJob hitJob(const render::RenderJob& job) {
    render::RenderJob traced = job;
    traced.settings = hitSettings(job.settings);
    traced.views = hitViews();
    traced.display = false;
    traced.statistics = true;
    traced.progress = {};
    return traced;
}

measure::GBufferPicture gbufferPicture(const render::RenderResult& result) {
    return {viewOf(result, "depth"), viewOf(result, "normal"), viewOf(result, "reflectivity")};
}

Result<measure::HitReport> measureHits(const render::RenderJob& job, const render::RenderResult& result) {
    GLINT_TRY(inputs, render::loadJobInputs(job));
    GLINT_TRY(oracle, measure::RayOracle::create(*inputs.scene, inputs.pose));
    const render::View view = render::makeView(inputs.camera, result.width, result.height);
    const measure::GBufferPicture gbuffer = gbufferPicture(result);
    return measure::judgeHits(view, gbuffer, measure::traceTruth(oracle, view, gbuffer), viewOf(result, "ray"));
}

Json hitFiguresJson(const measure::HitFigures& figures, const OutcomeNames& outcomeNames) {
    Json json;
    json["rays"] = figures.rays;
    json["visibleTruths"] = figures.visibleTruths;
    json["facingAway"] = figures.facingAway;
    json["reported"] = figures.reported;
    json["right"] = figures.right;
    json["precision"] = figures.precision();
    json["recall"] = figures.recall();
    json["positionErrorMedian"] = figures.positionErrorMedian;
    json["positionError95"] = figures.positionError95;
    json["lookupsPerRay"] = figures.lookupsMean;
    json["lookups95"] = figures.lookups95;
    json["dipping"] = figures.dipping;
    json["dippingWrong"] = figures.dippingWrong;
    json["outcomes"] = countsJson(figures.outcomes, outcomeNames);
    json["missedByOutcome"] = countsJson(figures.missedByOutcome, outcomeNames);
    Json wrong = Json::object();
    for (size_t i = 0; i < measure::kTruthKinds; ++i)
        if (figures.wrongByTruth[i] > 0)
            wrong[kTruthNames[i]] = figures.wrongByTruth[i];
    json["wrongByTruth"] = std::move(wrong);
    Json distances = Json::object();
    for (size_t i = 0; i < figures.wrongPlaceByDistance.size(); ++i) {
        const std::string name = i < measure::kDistanceBandsPX.size()
                                     ? fmt::format("to {:g} px", measure::kDistanceBandsPX[i])
                                     : std::string("farther");
        distances[name] = figures.wrongPlaceByDistance[i];
    }
    json["wrongPlaceByDistance"] = std::move(distances);
    return json;
}

Json hitReportJson(const measure::HitReport& report, const OutcomeNames& outcomeNames) {
    Json json = hitFiguresJson(report.all, outcomeNames);
    for (size_t band = 0; band < report.bands.size(); ++band)
        json[kBandNames[band]] = hitFiguresJson(report.bands[band], outcomeNames);
    return json;
}

} // namespace glint::cli
