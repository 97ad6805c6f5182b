// Axis-aligned boxes.
#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace glint::rays {

struct Bounds {
    glm::vec3 low = glm::vec3(std::numeric_limits<float>::infinity()); ///< empty: every point is outside
    glm::vec3 high = glm::vec3(-std::numeric_limits<float>::infinity());

    bool empty() const { return !(low.x <= high.x); }
    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Half the surface area, 0 for an empty box. The probability that a long random ray intersects the box is
    /// proportional to it.
    float halfArea() const {
        if (empty())
            return 0;
        const glm::vec3 size = high - low;
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
    glm::vec3 center() const { return low * 0.5f + high * 0.5f; } // the sum of two large ones may overflow
};

} // namespace glint::rays
