// Creates the environment of a job on the GPU.
#pragma once

#include "lab/job/job_inputs.hpp"
#include "lab/renderer/environment.hpp"

namespace glint::render {

/// Errors: those of Environment.
Result<Environment> makeEnvironment(gpu::Context& context, const JobInputs& inputs, const RenderSettings& settings);

} // namespace glint::render
