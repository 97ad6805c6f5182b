// KHR_draco_mesh_compression: the vertices and triangles of a primitive packed with Draco.
#pragma once

#include "scene/gltf/document.hpp"

#include <map>

namespace glint::scene::gltf {

/// A decoded primitive, in the shape that uncompressed data would have had.
struct DracoMesh {
    std::vector<uint32_t> indices;                          ///< of triangles
    std::map<std::string, std::vector<uint8_t>> attributes; ///< packed elements in the accessor's component type
};

/// Decodes what `extension` points at. `attributes` are the primitive's own: their accessors say the wanted types.
DracoMesh decodeDraco(Document& document, const JsonObject& extension, const JsonObject& attributes);

} // namespace glint::scene::gltf
