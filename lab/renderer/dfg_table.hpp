// The split-sum table: the reflectance of a GGX lobe under uniform light (shaders/lib/dfg.glsl).
#pragma once

#include "gpu/resources.hpp"

namespace glint::render {

/// RG16F, 128 x 128: red scales f0, green adds f90; x = NoV, y = perceptual roughness, both [0, 1].
Result<gpu::Image> makeDfgTable(gpu::Context& context);

} // namespace glint::render
