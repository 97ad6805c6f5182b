// Normals and tangents, which a file may lack or store incorrectly; always unit length afterwards.
#pragma once

#include "lab/scene/gltf/document.hpp"

namespace glint::scene::gltf {

/// Normalizes normals and tangents. Normals that cannot be normalized (zero, NaN) become the average of the adjacent
/// faces; such tangents become any direction orthogonal to the normal.
void repairShadingFrames(Geometry& geometry);

/// Gives every triangle its own three vertices and their flat normal (glTF 2.0, section 3.7.2.1). Tangents from the
/// file are dropped, as the specification requires.
void makeFlatNormals(Document& document, Primitive& primitive);

/// Computes tangents (lab/scene/tangents.hpp) for texture coordinate set `texCoord` and splits the vertices whose
/// triangles disagree, such as those along a mirrored seam. Does nothing for a primitive without that set.
void makeTangents(Document& document, Primitive& primitive, uint32_t texCoord);

} // namespace glint::scene::gltf
