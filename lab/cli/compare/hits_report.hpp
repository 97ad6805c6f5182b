// Formats `measure.hits` as JSON.
#pragma once

#include "lab/measure/truth/ray_hits.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace glint::cli {

/// {"rays", "visibleTruths", "facingAway", "reported", "right", "precision", "recall", "positionErrorMedian",
///  "positionError95", "lookupsPerRay", "lookups95", "dipping", "dippingWrong", "outcomes": {name: rays},
///  "missedByOutcome": {...}, "wrongByTruth": {...}, "wrongPlaceByDistance": {...}}
/// `outcomeNames`  RenderStats::outcomes
nlohmann::ordered_json hitFiguresJson(const measure::HitFigures& figures,
                                      const std::vector<std::pair<std::string, uint64_t>>& outcomeNames);

/// Returns the figures over all rays, and under "mirror", "glossy" and "rough" those of each roughness band.
nlohmann::ordered_json hitReportJson(const measure::HitReport& report,
                                     const std::vector<std::pair<std::string, uint64_t>>& outcomeNames);

} // namespace glint::cli
