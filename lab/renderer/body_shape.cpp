#include "lab/renderer/body_shape.hpp"

#include "lab/renderer/gpu_materials.hpp"

#include <cmath>

namespace glint::render {
namespace {

/// A ball's radius is half its thickness. An object with less than a fifth of that curvature is a plate, even if bent.
constexpr double kPlateFrom = 5;

/// 1 / metres in the mesh's space: difference of corner normals per length, area-weighted mean.
double meanCurvature(const scene::Geometry& geometry) {
    double sum = 0, all = 0;
    const auto& indices = geometry.indices;
    for (size_t i = 0; i + 2 < indices.size() && !geometry.normals.empty(); i += 3) {
        double turned = 0, way = 0;
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint32_t from = indices[i + corner];
            const uint32_t to = indices[i + (corner + 1) % 3];
            turned += glm::distance(geometry.normals[from], geometry.normals[to]);
            way += glm::distance(geometry.positions[from], geometry.positions[to]);
        }
        const glm::vec3& first = geometry.positions[indices[i]];
        const double area = glm::length(
            glm::cross(geometry.positions[indices[i + 1]] - first, geometry.positions[indices[i + 2]] - first));
        if (way > 0 && std::isfinite(area)) {
            sum += area * turned / way;
            all += area;
        }
    }
    return all > 0 ? sum / all : 0;
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
    const double radius = material.thicknessFactor / 2;
    return meanCurvature(geometry) * kPlateFrom * radius >= 1 ? BodyShape::Sphere : BodyShape::Plane;
}

} // namespace glint::render
