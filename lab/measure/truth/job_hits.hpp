// Compares a job's rays with the exact ones: defines the job to render for that, and judges its result.
#pragma once

#include "lab/job/job_inputs.hpp"
#include "lab/job/render_job.hpp"
#include "lab/measure/truth/ray_hits.hpp"

#include <optional>

namespace glint::measure {

/// True if each ray of a frame with these settings states how certain its answer is, and no pixel mixes the answers of
/// several.
bool statesCertainty(const render::ProgramSettings& settings);

/// Returns these settings with every reflective pixel traced along its mirror direction: no threshold, no roughness
/// cut, no jitter, one sample per pixel. Hits are measured with them.
render::ProgramSettings hitSettings(const render::ProgramSettings& settings);

/// Returns the views that measureHits and TruthKeeper require.
std::vector<std::string> hitViews();

/// Returns the job to render for measureHits.
render::RenderJob hitJob(const render::RenderJob& job);

/// Traces the exact rays on the CPU and judges the rays of the job. `result` is the result of hitJob. Errors: those of
/// the scene's readers; Unsupported if the CPU cannot trace rays.
Result<HitReport> measureHits(const render::RenderJob& job, const render::RenderResult& result);

/// Judges successive results of one scene at one time. The exact rays are kept while the G-buffer does not change, so
/// that several tracer settings share them.
class TruthKeeper {
public:
    /// `inputs`  the same scene and pose in every call
    /// `view`    the view that `traced` was rendered with
    /// `traced`  must have hitViews
    /// `knowsCertainty`  statesCertainty of its settings
    /// Errors: Unsupported if the CPU cannot trace rays.
    Result<HitReport> judge(const render::JobInputs& inputs, const render::View& view,
                            const render::RenderResult& traced, bool knowsCertainty);

private:
    std::optional<RayOracle> oracle_;
    std::vector<std::vector<float>> gbuffer_;
    std::vector<RayTruth> truths_;
};

} // namespace glint::measure
