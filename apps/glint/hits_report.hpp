// `measure.hits`: how well a job's rays agree with the exact ones.
#pragma once

#include "measure/ray_hits.hpp"
#include "render/render_job.hpp"

#include <nlohmann/json_fwd.hpp>

namespace glint::cli {

/// These settings with every reflective pixel traced along its mirror direction: no threshold, no roughness cut, no
/// jitter, one sample a pixel. Hits are measured on it.
render::ProgramSettings hitSettings(const render::ProgramSettings& settings);

/// The views that measureHits needs.
std::vector<std::string> hitViews();

/// The job to render for measureHits.
render::RenderJob hitJob(const render::RenderJob& job);

/// Traces the exact rays on the CPU and judges the job's own. `result` is hitJob's.
/// Errors: as the scene's readers give them; Unsupported where the CPU cannot trace.
Result<measure::HitReport> measureHits(const render::RenderJob& job, const render::RenderResult& result);

/// The G-buffer of a result that has hitViews.
measure::GBufferPicture gbufferPicture(const render::RenderResult& result);

/// {"rays", "visibleTruths", "facingAway", "reported", "right", "precision", "recall", "positionErrorMedian",
///  "positionError95", "lookupsPerRay", "lookups95", "dipping", "dippingWrong", "outcomes": {name: rays},
///  "missedByOutcome": {...}, "wrongByTruth": {...}, "wrongPlaceByDistance": {...}}
/// `outcomeNames`  RenderStats::outcomes
nlohmann::ordered_json hitFiguresJson(const measure::HitFigures& figures,
                                      const std::vector<std::pair<std::string, uint64_t>>& outcomeNames);

/// The figures over all rays, and under "mirror", "glossy" and "rough" those of each roughness band.
nlohmann::ordered_json hitReportJson(const measure::HitReport& report,
                                     const std::vector<std::pair<std::string, uint64_t>>& outcomeNames);

} // namespace glint::cli
