// glint bake: turns a RenderJob into a set of probes.
#pragma once

#include "gpu/context.hpp"
#include "lab/job/render_job.hpp"
#include "lab/sources/probe_baking.hpp"

namespace glint::render {

/// Uses the scene, time, environment, camera, size and renderer settings of `job`. Errors: those of the scene's
/// readers, the device and the settings.
Result<ProbeSet> runBakeJob(gpu::Context& context, const RenderJob& job, const BakeOptions& options);

} // namespace glint::render
