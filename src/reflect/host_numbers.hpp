// A host's plain arrays of numbers, as vectors, and whether they can be.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace glint::reflect {

constexpr float kLongest = 1e9f; ///< metres: beyond, single precision has no room for a probe or a mirror

inline glm::vec3 toVec(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// False for what is not a number, too.
inline bool within(std::span<const float> values, float low, float high) {
    return std::ranges::all_of(values, [&](float value) { return value >= low && value <= high; });
}

} // namespace glint::reflect
