// The environment that a job's words ask for, on the GPU.
#pragma once

#include "render/environment.hpp"
#include "render/job_inputs.hpp"

namespace glint::render {

/// Errors: as Environment gives them.
Result<Environment> makeEnvironment(gpu::Context& context, const JobInputs& inputs, const RenderSettings& settings);

} // namespace glint::render
