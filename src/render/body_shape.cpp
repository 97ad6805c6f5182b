#include "render/body_shape.hpp"

#include "render/gpu_materials.hpp"

#include <algorithm>

namespace glint::render {
namespace {

/// Is more than half of the area made of triangles whose corners have one normal?
bool isMostlyFlat(const scene::Geometry& geometry) {
    constexpr float kOneNormal = 0.9998f; // cosine of a degree
    if (geometry.normals.empty())
        return true;
    double flat = 0, all = 0;
    const auto& indices = geometry.indices;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::vec3& a = geometry.positions[indices[i]];
        const glm::vec3& b = geometry.positions[indices[i + 1]];
        const glm::vec3& c = geometry.positions[indices[i + 2]];
        const double area = glm::length(glm::cross(b - a, c - a));
        const glm::vec3& normal = geometry.normals[indices[i]];
        const float leans = std::min(glm::dot(normal, geometry.normals[indices[i + 1]]),
                                     glm::dot(normal, geometry.normals[indices[i + 2]]));
        flat += leans >= kOneNormal ? area : 0;
        all += area;
    }
    return flat > all / 2;
}

} // namespace

BodyShape bodyShape(const scene::Material& material, const scene::Geometry& geometry) {
    if (!transmitsLight(material))
        return BodyShape::Straight;
    switch (material.refraction) {
    case scene::RefractionShape::None: return BodyShape::Straight;
    case scene::RefractionShape::Sphere: return BodyShape::Sphere;
    case scene::RefractionShape::Plane: return BodyShape::Plane;
    case scene::RefractionShape::Thin: return BodyShape::Thin;
    case scene::RefractionShape::ByShape: break;
    }
    if (material.thicknessFactor <= 0)
        return BodyShape::Straight;
    return isMostlyFlat(geometry) ? BodyShape::Plane : BodyShape::Sphere;
}

} // namespace glint::render
