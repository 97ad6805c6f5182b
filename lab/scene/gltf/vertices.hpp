// Rearranges all arrays of a primitive together.
#pragma once

#include "lab/scene/scene.hpp"

#include <cstdint>
#include <span>

namespace glint::scene::gltf {

/// Returns the bytes per vertex of this primitive, in all arrays together.
uint64_t bytesPerVertex(const Primitive& primitive);

/// Makes new vertex i a copy of old vertex `sources[i]`, in every array. The caller sets new indices.
void gatherVertices(Primitive& primitive, std::span<const uint32_t> sources);

} // namespace glint::scene::gltf
