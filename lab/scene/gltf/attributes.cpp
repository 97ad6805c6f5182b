#include "lab/scene/gltf/attributes.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::gltf {
namespace {

/// Converts floats to vectors of `N` components; non-finite values become 0.
template <int N>
std::vector<glm::vec<N, float>> toVectors(const std::vector<float>& floats) {
    std::vector<glm::vec<N, float>> vectors(floats.size() / N);
    for (size_t i = 0; i < vectors.size(); ++i)
        for (int k = 0; k < N; ++k)
            vectors[i][k] = std::isfinite(floats[i * N + size_t(k)]) ? floats[i * N + size_t(k)] : 0.0f;
    return vectors;
}

Accessor asNormalized(const Accessor& accessor) {
    Accessor result = accessor;
    result.normalized = accessor.componentType != ComponentType::Float32;
    return result;
}

} // namespace

const Accessor* Attributes::find(const char* name, std::initializer_list<ElementShape> shapes) {
    const Accessor* accessor = findAccessor(document_, object_, name, shapes);
    if (accessor && vertexCount_ && accessor->count != *vertexCount_) {
        document_.diagnostics.fail("{} has {} elements (accessor {}) but the primitive has {} vertices",
                                   object_.pathOf(name), accessor->count, accessor->index, *vertexCount_);
        return nullptr;
    }
    return accessor;
}

std::vector<float> Attributes::floats(const char* name, const Accessor& accessor) {
    if (draco_) {
        const auto packed = draco_->attributes.find(name);
        if (packed != draco_->attributes.end())
            return readFloats(document_, accessor, packed->second);
    }
    return readFloats(document_, accessor);
}

std::vector<glm::vec3> Attributes::positions(const char* name) {
    const Accessor* accessor = find(name, {kVec3});
    if (!accessor)
        return {};
    const std::vector<float> values = floats(name, *accessor);
    const auto bad = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
    if (bad != values.end()) {
        document_.diagnostics.fail("accessor {}: element {} of {} is not finite", accessor->index,
                                   (bad - values.begin()) / 3, object_.pathOf(name));
        return {};
    }
    return toVectors<3>(values);
}

std::vector<glm::vec2> Attributes::vec2(const char* name) {
    const Accessor* accessor = find(name, {kVec2});
    return accessor ? toVectors<2>(floats(name, *accessor)) : std::vector<glm::vec2>();
}

std::vector<glm::vec3> Attributes::vec3(const char* name) {
    const Accessor* accessor = find(name, {kVec3});
    return accessor ? toVectors<3>(floats(name, *accessor)) : std::vector<glm::vec3>();
}

std::vector<glm::vec4> Attributes::vec4(const char* name) {
    const Accessor* accessor = find(name, {kVec4});
    return accessor ? toVectors<4>(floats(name, *accessor)) : std::vector<glm::vec4>();
}

std::vector<glm::vec4> Attributes::color(const char* name) {
    const Accessor* accessor = find(name, {kVec4, kVec3});
    if (!accessor)
        return {};
    const std::vector<float> values = floats(name, asNormalized(*accessor));
    if (accessor->shape == kVec4)
        return toVectors<4>(values);
    std::vector<glm::vec4> colors(values.size() / 3);
    for (size_t i = 0; i < colors.size(); ++i)
        colors[i] = {values[i * 3], values[i * 3 + 1], values[i * 3 + 2], 1};
    return colors;
}

std::vector<glm::vec4> Attributes::weights(const char* name) {
    const Accessor* accessor = find(name, {kVec4});
    return accessor ? toVectors<4>(floats(name, asNormalized(*accessor))) : std::vector<glm::vec4>();
}

std::vector<glm::u16vec4> Attributes::joints(const char* name) {
    const Accessor* accessor = find(name, {kVec4});
    if (!accessor)
        return {};
    const auto packed = draco_ ? draco_->attributes.find(name) : decltype(draco_->attributes.find(name))();
    const bool inDraco = draco_ && packed != draco_->attributes.end();
    const std::vector<uint32_t> values =
        inDraco ? readIntegers(document_, *accessor, packed->second) : readIntegers(document_, *accessor);
    std::vector<glm::u16vec4> joints(values.size() / 4);
    for (size_t i = 0; i < values.size(); ++i) {
        if (values[i] > std::numeric_limits<uint16_t>::max()) {
            document_.diagnostics.fail("{} names joint {}", object_.pathOf(name), values[i]);
            return {};
        }
        joints[i / 4][int(i % 4)] = static_cast<uint16_t>(values[i]);
    }
    return joints;
}

} // namespace glint::scene::gltf
