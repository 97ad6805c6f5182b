// The vertex attributes of one primitive, whether they lie in accessors or in Draco's data.
#pragma once

#include "scene/gltf/accessor.hpp"
#include "scene/gltf/draco.hpp"

namespace glint::scene::gltf {

class Attributes {
public:
    /// `draco` may be null. `vertexCount` is checked against every attribute read.
    Attributes(Document& document, const JsonObject& object, const DracoMesh* draco)
        : document_(document), object_(object), draco_(draco) {}

    bool has(const char* name) const { return object_.has(name); }

    /// Every array must be this long; before it is called any length is taken.
    void setVertexCount(uint64_t count) { vertexCount_ = count; }

    /// Empty if absent or after a mistake. NaN and infinities are a mistake in positions; elsewhere, where real
    /// exporters let them slip in, they become 0.
    std::vector<glm::vec3> positions(const char* name);
    std::vector<glm::vec2> vec2(const char* name);
    std::vector<glm::vec3> vec3(const char* name);
    std::vector<glm::vec4> vec4(const char* name);
    /// COLOR_n: VEC3 gets alpha 1. Integers are normalized whether or not the accessor says so.
    std::vector<glm::vec4> color(const char* name);
    /// WEIGHTS_n: integers are normalized likewise.
    std::vector<glm::vec4> weights(const char* name);
    std::vector<glm::u16vec4> joints(const char* name);

private:
    const Accessor* find(const char* name, std::initializer_list<ElementShape> shapes);
    std::vector<float> floats(const char* name, const Accessor& accessor);

    Document& document_;
    const JsonObject& object_;
    const DracoMesh* draco_;
    std::optional<uint64_t> vertexCount_;
};

} // namespace glint::scene::gltf
