// A pixel's ray in words: docs/inspect.md lists the fields.
#pragma once

#include "render/render_job.hpp"

#include <string>

namespace glint::cli {

/// `result` holds an inspection.
std::string inspectionJson(const render::RenderJob& job, const render::RenderResult& result);

} // namespace glint::cli
