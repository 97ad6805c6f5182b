// Converts and checks a host's plain arrays of numbers.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace glint::reflect {

constexpr float kLongest = 1e9f; ///< metres; beyond this, single precision is too coarse for a probe or a mirror

inline glm::vec3 toVec(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// Also false for NaN.
inline bool within(std::span<const float> values, float low, float high) {
    return std::ranges::all_of(values, [&](float value) { return value >= low && value <= high; });
}

} // namespace glint::reflect
