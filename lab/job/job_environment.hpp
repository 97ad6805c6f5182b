// Creates the environment of a job on the GPU.
#pragma once

#include "lab/job/job_inputs.hpp"
#include "lab/renderer/environment.hpp"

namespace glint::render {

/// Where the strong lights of the environment's picture are.
enum class StrongLights {
    Taken, ///< they become lights, for a renderer that lights its surfaces with them
    Kept,  ///< in the cubes: another renderer has lit what is shown, and nothing else brings their light
};

/// Errors: those of Environment.
Result<Environment> makeEnvironment(gpu::Context& context, const JobInputs& inputs, const RenderSettings& settings,
                                    StrongLights strongLights);

} // namespace glint::render
