#include "render/frustum.hpp"

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

scene::Bounds transformedBounds(const scene::Bounds& local, const glm::mat4& localToWorld) {
    if (local.empty())
        return {};
    const glm::vec3 center = (local.min + local.max) * 0.5f, half = (local.max - local.min) * 0.5f;
    glm::mat3 sizes(localToWorld);
    for (int i = 0; i < 3; ++i)
        sizes[i] = glm::abs(sizes[i]);
    const glm::vec3 centerWS(localToWorld * glm::vec4(center, 1)), halfWS = sizes * half;
    scene::Bounds out;
    out.min = centerWS - halfWS;
    out.max = centerWS + halfWS;
    return out;
}

} // namespace glint::render
