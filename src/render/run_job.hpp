// Does a RenderJob: scene, renderer, reflections, read-back. The frame of our own programs, as a host writes it: it
// reaches the reflections only through include/glint.
#pragma once

#include "gpu/context.hpp"
#include "render/render_job.hpp"

namespace glint::render {

/// On a device of its own. Errors: as the scene's readers, the device and the settings give them; with
/// RenderJob::validate also the first message of the validation layer.
Result<RenderResult> runJob(const RenderJob& job);

/// On a device that is there already (RenderJob::device and validate are the caller's matter then).
Result<RenderResult> runJob(gpu::Context& context, const RenderJob& job);

} // namespace glint::render
