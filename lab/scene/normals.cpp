#include "lab/scene/normals.hpp"

namespace glint::scene {

glm::vec3 triangleNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 origin(a);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
    const double length = glm::length(normal);
    return length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 0, 1);
}

void computeFlatNormals(Geometry& geometry) {
    geometry.normals.resize(geometry.positions.size());
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
        const uint32_t* corner = &geometry.indices[i];
        const glm::vec3 normal =
            triangleNormal(geometry.positions[corner[0]], geometry.positions[corner[1]], geometry.positions[corner[2]]);
        for (int k = 0; k < 3; ++k)
            geometry.normals[corner[k]] = normal;
    }
}

} // namespace glint::scene
