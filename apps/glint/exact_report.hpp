// `measure.exact`: how far the rendered picture is from the exact one.
#pragma once

#include "measure/exact_picture.hpp"
#include "render/render_job.hpp"

#include <nlohmann/json_fwd.hpp>

namespace glint::cli {

/// Traces the job's exact picture on the CPU and compares the view "composite" with it.
/// Errors: InvalidInput where the scene has none, see measure::exactPicture.
Result<measure::MirrorError> measureExact(const render::RenderJob& job, const render::RenderResult& result);

/// {"mirrorPixels", "wrongPixels", "wrongShare", "oneBouncePixels", "oneBounceWrong", "oneBounceWrongShare",
/// "byBounces": [{"bounces", "pixels", "wrong"}]}
nlohmann::ordered_json exactJson(const measure::MirrorError& error);

} // namespace glint::cli
