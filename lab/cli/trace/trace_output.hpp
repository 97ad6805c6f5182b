// The output of `glint trace`: layers and figures.
#pragma once

#include "lab/measure/truth/specular_error.hpp"
#include "lab/session/trace_job.hpp"

#include <optional>
#include <string>

namespace glint::cli {

/// What is computed from the views of a traced G-buffer.
struct TraceFigures {
    /// Reflected radiance under the material's specular response, RGBA; absent where it is not defined: with the lerp
    /// composite, or another strength than 1.
    std::optional<std::vector<float>> specular;
    std::optional<measure::ByBand<measure::SpecularError>> error; ///< with the mapping's `reference`
};

/// `result` must have the views composite, scene, weights, roughness and reflectivity.
TraceFigures traceFigures(const render::TraceJob& job, const render::TraceInputs& inputs,
                          const render::RenderResult& result);

/// As writePictures, the job's views only; an EXR file has the layer "specular" too. Errors: Io.
Result<void> writeTraced(const std::string& path, const render::TraceJob& job, const render::RenderResult& result,
                         const TraceFigures& figures);

/// As statsJson with "gbuffer", "color", "surfaces", "check": {"testedPixels", "normalsAgree", "findings"}, and with a
/// reference
/// "error": {"mirror", "glossy", "rough", "all": {"pixels", "relativeMse", "psnr", "energy"}}.
std::string traceStatsJson(const render::TraceJob& job, const render::TraceInputs& inputs,
                           const render::RenderResult& result, const TraceFigures& figures);

} // namespace glint::cli
