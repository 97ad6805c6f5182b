// Expands strips, fans and loops to lists.
#pragma once

#include "lab/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace glint::scene::gltf {

/// glTF's numbers for primitive modes.
enum class PrimitiveMode : uint8_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

Topology listTopology(PrimitiveMode mode);

/// Returns the indices of a list that draws the same as `indices` in `mode`. Surplus indices at the end of a list are
/// dropped.
std::vector<uint32_t> expandToList(PrimitiveMode mode, std::vector<uint32_t> indices);

} // namespace glint::scene::gltf
