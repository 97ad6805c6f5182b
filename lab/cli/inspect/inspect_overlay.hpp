// Draws a pixel's ray over the image: docs/inspect.md explains the colours.
#pragma once

#include "glint/inspection.hpp"

#include <span>
#include <string_view>

namespace glint::cli {

/// Returns the colour of a sample's decision (RaySample::decision): RGB as displayed, [0, 1].
Float3 decisionColor(std::string_view decision);

/// Draws the screen-space line from start to end and every sample: pixels as discs, cells of the pyramid as outlined
/// squares, both in the colour of their decision. The start is a diamond, a hit a ring with four ticks, the end of a
/// ray without a hit a cross. Sizes scale with the image height. `rgb`: 3 bytes per pixel, rows from the top.
void drawRay(const RayInspection& inspection, uint32_t width, uint32_t height, std::span<uint8_t> rgb);

} // namespace glint::cli
