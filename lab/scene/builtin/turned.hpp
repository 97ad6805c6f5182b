// Surfaces of revolution around +Y: cylinders, mouldings, and the fluted column that is built from them.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <span>

namespace glint::scene::builtin {

/// Turns a profile of (radius, y) around +Y. The outside is to the right of the profile's direction when radius points
/// right and y up, so an upward profile encloses a solid. The shape is closed if the profile starts and ends with
/// radius 0. Corners sharper than 40 degrees stay sharp. uvs: u once around, v in metres along the profile.
Geometry lathe(std::span<const glm::vec2> profile, int columns = 48);

/// Stands on y = 0.
Geometry cylinder(float radius, float height, int columns = 48);

struct ColumnShape {
    float height = 4;     ///< metres, including base and capital
    float radius = 0.36f; ///< metres, of the shaft at its foot
    int flutes = 20;
    float fluteDepth = 0.1f; ///< fraction of the radius
    int columnsPerFlute = 4;
    int rows = 16;
};

/// A column after the Doric and Attic orders: square plinth, turned base, fluted shaft with entasis (it narrows upward,
/// slowly at first), turned capital, square abacus. Stands on y = 0; consists of several closed solids that overlap.
Geometry flutedColumn(const ColumnShape& shape);

} // namespace glint::scene::builtin
