// A pixel's ray drawn over the picture: docs/inspect.md says what the colours mean.
#pragma once

#include "glint/inspection.hpp"

#include <span>
#include <string_view>

namespace glint::cli {

/// Of what a sample decided (RaySample::decision): RGB as displayed, [0, 1].
Float3 decisionColor(std::string_view decision);

/// The line on screen from start to end, every sample (pixels as discs, cells of the pyramid as outlined squares, both
/// in the colour of what they decided), the start as a diamond, an answer as a ring with four ticks, the end of
/// a ray without one as a cross. Sizes follow the
/// picture's height.
/// `rgb` 3 bytes a pixel, rows from the top
void drawRay(const RayInspection& inspection, uint32_t width, uint32_t height, std::span<uint8_t> rgb);

} // namespace glint::cli
