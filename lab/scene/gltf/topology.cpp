#include "lab/scene/gltf/topology.hpp"

namespace glint::scene::gltf {

Topology listTopology(PrimitiveMode mode) {
    switch (mode) {
    case PrimitiveMode::Points: return Topology::Points;
    case PrimitiveMode::Lines:
    case PrimitiveMode::LineLoop:
    case PrimitiveMode::LineStrip: return Topology::Lines;
    default: return Topology::Triangles;
    }
}

// glTF 2.0 specification, section 3.7.2.1: this vertex order keeps the winding along a strip or fan.
std::vector<uint32_t> expandToList(PrimitiveMode mode, std::vector<uint32_t> indices) {
    const size_t count = indices.size();
    std::vector<uint32_t> list;
    switch (mode) {
    case PrimitiveMode::Points: return indices;
    case PrimitiveMode::Lines: indices.resize(count / 2 * 2); return indices;
    case PrimitiveMode::Triangles: indices.resize(count / 3 * 3); return indices;
    case PrimitiveMode::LineLoop:
    case PrimitiveMode::LineStrip:
        for (size_t i = 0; i + 1 < count; ++i)
            list.insert(list.end(), {indices[i], indices[i + 1]});
        if (mode == PrimitiveMode::LineLoop && count > 1)
            list.insert(list.end(), {indices.back(), indices.front()});
        return list;
    case PrimitiveMode::TriangleStrip:
        for (size_t i = 0; i + 2 < count; ++i)
            list.insert(list.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
        return list;
    case PrimitiveMode::TriangleFan:
        for (size_t i = 0; i + 2 < count; ++i)
            list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
        return list;
    }
    return list;
}

} // namespace glint::scene::gltf
