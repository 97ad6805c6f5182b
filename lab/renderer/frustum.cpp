#include "lab/renderer/frustum.hpp"

namespace glint::render {

Frustum::Frustum(const glm::mat4& worldToClip) {
    const glm::mat4 rows = glm::transpose(worldToClip);
    constexpr float kWider = 1.01f;
    planes_ = {kWider * rows[3] + rows[0], kWider * rows[3] - rows[0], kWider * rows[3] + rows[1],
               kWider * rows[3] - rows[1], kWider * rows[3] - rows[2]};
}

bool Frustum::mayShow(const scene::Bounds& boundsWS) const {
    for (const glm::vec4& plane : planes_) {
        // The box's corner that lies farthest inside (Greene 1994, "Detecting Intersection of a Rectangular Solid and a
        // Convex Polyhedron").
        const glm::vec3 normal(plane);
        const glm::vec3 corner = glm::mix(boundsWS.min, boundsWS.max, glm::greaterThan(normal, glm::vec3(0)));
        if (glm::dot(normal, corner) + plane.w < 0)
            return false;
    }
    return true;
}

} // namespace glint::render
