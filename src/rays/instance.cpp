#include "rays/instance.hpp"

#include "rays/mesh.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace glint::rays {

std::optional<Placement> placementOf(const RayInstance& instance) {
    const glm::dmat4 matrix(glm::make_mat4(instance.localToWorld.data()));
    const glm::dmat3 linear(matrix);
    const glm::dmat3 inverse = glm::inverse(linear);
    const glm::dvec3 translation(matrix[3]);
    const auto fits = [](const glm::dvec3& v) {
        return glm::all(glm::lessThanEqual(glm::abs(v), glm::dvec3(static_cast<double>(kFarthest)))); // false for NaN
    };
    for (int i = 0; i < 3; ++i)
        if (!fits(linear[i]) || !fits(inverse[i]))
            return std::nullopt;
    if (!fits(translation))
        return std::nullopt;
    return Placement{glm::dmat4x3(linear[0], linear[1], linear[2], translation), inverse};
}

Bounds boundsWS(const Placement& placement, const Bounds& local) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point(corner & 1 ? local.high.x : local.low.x, corner & 2 ? local.high.y : local.low.y,
                               corner & 4 ? local.high.z : local.low.z, 1);
        const glm::dvec3 position = placement.localToWorld * point;
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    // The margin is a few rounding errors of the largest coordinate, for the transform there and back.
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    const double slack = std::max({farthest.x, farthest.y, farthest.z}) * 0x1p-20;
    Bounds bounds;
    bounds.add(glm::vec3(low - slack));
    bounds.add(glm::vec3(high + slack));
    return bounds;
}

} // namespace glint::rays
