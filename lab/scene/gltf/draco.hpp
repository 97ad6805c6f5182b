// KHR_draco_mesh_compression: decodes the vertices and triangles of a primitive.
#pragma once

#include "lab/scene/gltf/document.hpp"

#include <map>

namespace glint::scene::gltf {

/// A decoded primitive, in the form of uncompressed data.
struct DracoMesh {
    std::vector<uint32_t> indices;                          ///< of triangles
    std::map<std::string, std::vector<uint8_t>> attributes; ///< packed elements in the accessor's component type
};

/// Decodes the data that `extension` refers to. `attributes` are the primitive's own: their accessors determine the
/// component types.
DracoMesh decodeDraco(Document& document, const JsonObject& extension, const JsonObject& attributes);

} // namespace glint::scene::gltf
