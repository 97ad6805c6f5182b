// glint bake: from a job's words to a set of probes.
#pragma once

#include "gpu/context.hpp"
#include "render/probe_baking.hpp"
#include "render/render_job.hpp"

namespace glint::render {

/// Of `job` the scene, the moment, the environment, the camera, the size and the renderer's settings count.
/// Errors: as the scene's readers, the device and the settings give them.
Result<ProbeSet> runBakeJob(gpu::Context& context, const RenderJob& job, const BakeOptions& options);

} // namespace glint::render
