// The asked pixel's ray, drawn over the picture: docs/inspect.md says what marks and colours mean.
#pragma once

#include "canvas.hpp"

namespace glint::view {

/// `size`  of the picture that the ray was traced in, in pixels
void drawRayOverlay(const RayInspection& ray, const Canvas& canvas, glm::vec2 size);

} // namespace glint::view
