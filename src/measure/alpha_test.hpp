// The alpha test of masked surfaces, on the CPU: which points of a triangle are holes.
#pragma once

#include "scene/scene.hpp"

#include <glm/glm.hpp>

namespace glint::measure {

/// Where on a geometry: a triangle's first index, and the weights of its second and third corner.
struct TrianglePoint {
    size_t firstIndex = 0; ///< into Geometry::indices
    double u = 0;
    double v = 0;
};

/// Base alpha, texture times factor times vertex colour, as the raster pass reads it at mip 0 (bilinear, or nearest
/// where the sampler says so). Missing textures, coordinates and colours count as the raster pass counts them.
double baseAlpha(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
                 const TrianglePoint& point);

/// Does the raster pass discard this point?
bool isHole(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
            const TrianglePoint& point);

} // namespace glint::measure
