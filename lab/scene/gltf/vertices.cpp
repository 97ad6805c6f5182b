#include "lab/scene/gltf/vertices.hpp"

namespace glint::scene::gltf {
namespace {

/// Calls `visit` with every vertex array; the one place to add a new one.
template <class P, class Visit>
void forEachArray(P& primitive, Visit&& visit) {
    auto& geometry = primitive.geometry;
    visit(geometry.positions);
    visit(geometry.normals);
    visit(geometry.tangents);
    for (auto& uvs : geometry.uvs)
        visit(uvs);
    visit(geometry.colors);
    for (auto& set : primitive.skinSets) {
        visit(set.joints);
        visit(set.weights);
    }
    for (auto& target : primitive.morphTargets) {
        visit(target.positions);
        visit(target.normals);
        visit(target.tangents);
    }
}

} // namespace

uint64_t bytesPerVertex(const Primitive& primitive) {
    uint64_t bytes = 0;
    forEachArray(primitive, [&](const auto& array) { bytes += array.empty() ? 0 : sizeof(array[0]); });
    return bytes;
}

void gatherVertices(Primitive& primitive, std::span<const uint32_t> sources) {
    forEachArray(primitive, [&](auto& array) {
        if (array.empty())
            return;
        std::remove_reference_t<decltype(array)> gathered(sources.size());
        for (size_t i = 0; i < sources.size(); ++i)
            gathered[i] = array[sources[i]];
        array = std::move(gathered);
    });
}

} // namespace glint::scene::gltf
