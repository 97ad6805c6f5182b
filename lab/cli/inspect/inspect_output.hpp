// Formats the inspection of a pixel's ray: docs/inspect.md lists the fields.
#pragma once

#include "lab/job/render_job.hpp"

#include <string>

namespace glint::cli {

/// `result` must hold an inspection.
std::string inspectionJson(const render::RenderJob& job, const render::RenderResult& result);

} // namespace glint::cli
