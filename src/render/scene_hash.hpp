// What a bake depends on, as two numbers: the scene at its moment, and the light that it stands in.
#pragma once

#include "render/job_inputs.hpp"

namespace glint::render {

/// Geometry, where it stands, materials, textures and lights.
uint64_t sceneHash(const scene::Scene& scene, const scene::Pose& pose);

/// The environment and every setting that changes how surfaces are lit.
uint64_t lightHash(const JobInputs& inputs, const RenderSettings& settings);

} // namespace glint::render
