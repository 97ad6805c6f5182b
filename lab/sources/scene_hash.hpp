// Two hashes of what a bake depends on: the posed scene, and the lighting.
#pragma once

#include "lab/job/job_inputs.hpp"

namespace glint::render {

/// Hashes geometry, transforms, materials, textures and lights.
uint64_t sceneHash(const scene::Scene& scene, const scene::Pose& pose);

/// Hashes the environment and every setting that affects the lighting of surfaces.
uint64_t lightHash(const JobInputs& inputs, const RenderSettings& settings);

} // namespace glint::render
