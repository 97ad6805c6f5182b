// The cutouts of masked materials on the CPU: determines which points of a triangle are holes.
#pragma once

#include "lab/scene/scene.hpp"

#include <glm/glm.hpp>

namespace glint::measure {

/// A point of a geometry: a triangle's first index, and the weights of its second and third corner.
struct TrianglePoint {
    size_t firstIndex = 0; ///< index into Geometry::indices
    double u = 0;
    double v = 0;
};

/// Returns the base alpha, texture times factor times vertex colour, as the raster pass reads it at mip 0 (bilinear, or
/// nearest if the sampler requests it). Missing textures, coordinates and colours have the same defaults as in the
/// raster pass.
double baseAlpha(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
                 const TrianglePoint& point);

/// True if the raster pass discards this point.
bool isHole(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
            const TrianglePoint& point);

} // namespace glint::measure
