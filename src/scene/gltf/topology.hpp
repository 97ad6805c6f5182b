// Strips, fans and loops as plain lists.
#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace glint::scene::gltf {

/// glTF's numbers for primitive modes.
enum class PrimitiveMode : uint8_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

Topology listTopology(PrimitiveMode mode);

/// Indices of the list that draws what `indices` draw in `mode`. Indices left over at the end of a list are dropped.
std::vector<uint32_t> expandToList(PrimitiveMode mode, std::vector<uint32_t> indices);

} // namespace glint::scene::gltf
