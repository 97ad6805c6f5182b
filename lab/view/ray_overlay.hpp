// Draws the inspected pixel's ray over the picture: docs/inspect.md explains marks and colours.
#pragma once

#include "lab/view/canvas.hpp"

namespace glint::view {

/// `size`  of the picture that the ray was traced in, in pixels
void drawRayOverlay(const RayInspection& ray, const Canvas& canvas, glm::vec2 size);

} // namespace glint::view
