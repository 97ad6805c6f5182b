// The vertex attributes of one primitive, from accessors or from Draco data.
#pragma once

#include "lab/scene/gltf/accessor.hpp"
#include "lab/scene/gltf/draco.hpp"

namespace glint::scene::gltf {

class Attributes {
public:
    /// `draco` may be null. Every attribute's length is checked against `vertexCount`.
    Attributes(Document& document, const JsonObject& object, const DracoMesh* draco)
        : document_(document), object_(object), draco_(draco) {}

    bool has(const char* name) const { return object_.has(name); }

    /// Sets the required length of every array; before this call any length is accepted.
    void setVertexCount(uint64_t count) { vertexCount_ = count; }

    /// Empty if absent or after an error in the file. NaN and infinities are an error in positions. In other
    /// attributes, where real exporters write them, they become 0.
    std::vector<glm::vec3> positions(const char* name);
    std::vector<glm::vec2> vec2(const char* name);
    std::vector<glm::vec3> vec3(const char* name);
    std::vector<glm::vec4> vec4(const char* name);
    /// COLOR_n: VEC3 gets alpha 1. Integers are normalized even if the accessor does not declare it.
    std::vector<glm::vec4> color(const char* name);
    /// WEIGHTS_n: integers are normalized as well.
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
