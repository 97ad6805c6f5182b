#include "lab/cli/compare/hits_report.hpp"

#include <nlohmann/json.hpp>

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

/// By stated weight, from 0 to 1 in equal bins.
Json statedJson(const measure::HitFigures& figures) {
    Json bins = Json::array();
    for (const measure::AnswerShare& bin : figures.stated)
        bins.push_back({{"answers", bin.answers}, {"stated", bin.meanStated()}, {"right", bin.share()}});
    return bins;
}

} // namespace

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
    json["stated"] = statedJson(figures);
    return json;
}

Json hitReportJson(const measure::HitReport& report, const OutcomeNames& outcomeNames) {
    Json json = hitFiguresJson(report.all, outcomeNames);
    for (size_t band = 0; band < report.bands.size(); ++band)
        json[kBandNames[band]] = hitFiguresJson(report.bands[band], outcomeNames);
    return json;
}

} // namespace glint::cli
