// The basic solids of the built-in scenes. Sizes in metres, centred on the origin unless stated otherwise; every solid
// is closed and faces outward. Turned shapes: turned.hpp; tubes along a path: sweep.hpp.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <span>
#include <vector>

namespace glint::scene::builtin {

/// The sides of a box, in the order of glTF's axes.
enum class Side { PlusX, MinusX, PlusY, MinusY, PlusZ, MinusZ };
inline constexpr std::array kAllSides = {Side::PlusX,  Side::MinusX, Side::PlusY,
                                         Side::MinusY, Side::PlusZ,  Side::MinusZ};

/// One face of a box, for boxes whose faces have different materials. uvs in metres from the face's centre.
Geometry boxSide(const glm::vec3& halfExtent, Side side);

/// Six flat faces; uvs in metres, so that textures have the same scale on boxes of all sizes.
Geometry box(const glm::vec3& halfExtent);

/// A box with rounded edges and corners. `radius` is at most the smallest half extent. A quarter of the rounding has 2
/// * segments segments (1 looks like a bevel). uvs as for `box`.
Geometry roundedBox(const glm::vec3& halfExtent, float radius, int segments = 2);

/// A rectangle in y = 0 that faces +Y, divided into columns x rows. Not closed. uvs in metres.
Geometry plane(const glm::vec2& halfExtent, int columns = 1, int rows = 1);

/// uvs: u once around, v from the top to the bottom.
Geometry sphere(float radius, int columns = 48, int rows = 24);

/// The part of a sphere between two longitudes, in columns, for balls with sectors of different colours. Not closed.
Geometry sphereSector(float radius, int columns, int rows, int firstColumn, int endColumn);

/// A ring around +Z.
Geometry torus(float radius, float tubeRadius, int columns = 96, int rows = 16);

/// Extrudes a simple polygon (counter-clockwise seen from +Z, need not be convex) to `depth` along Z. Edges that turn
/// by less than 35 degrees share their normal, so that arcs look round.
Geometry extrude(std::span<const glm::vec2> outline, float depth);

/// The outline of a wall, `width` x `height` and standing on y = 0, with a round-headed opening: for an arcade on
/// columns.
std::vector<glm::vec2> archOutline(float width, float height, float openingRadius, int segments = 24);

/// A star with `points` tips.
std::vector<glm::vec2> starOutline(int points, float outerRadius, float innerRadius);

/// A picture frame around a rectangle in z = 0, with mitred corners; `border` wide, `depth` along Z.
Geometry frame(const glm::vec2& innerHalfExtent, float border, float depth);

} // namespace glint::scene::builtin
