// The error of a job's image against the exact one.
#pragma once

#include "lab/job/render_job.hpp"
#include "lab/measure/truth/exact_picture.hpp"

namespace glint::measure {

/// Traces the job's exact picture on the CPU and compares the view "composite" with it. Errors: InvalidArgument without
/// that view; InvalidInput if the scene has no exact picture, see exactPicture.
Result<MirrorError> measureExact(const render::RenderJob& job, const render::RenderResult& result);

} // namespace glint::measure
