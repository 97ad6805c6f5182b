// The storeys of builtin:city: rings of window bays in several styles, shop fronts, roofs. Geometry by material, for
// the caller to choose.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <array>
#include <cstdint>

namespace glint::scene::builtin {

/// A building's storeys are square rings; their centre is the origin, they stand on y = 0. Metres.
inline constexpr float kBuildingHalf = 9;
inline constexpr float kStoreyHeight = 3.3f;
inline constexpr float kShopHeight = 4.4f;

inline constexpr int kFacadeStyles = 6;

struct Storey {
    Geometry wall;
    Geometry trim;                 ///< sills, lintels, pilasters, balconies
    Geometry frame;                ///< windows' frames, railings
    Geometry glass;                ///< of dark windows
    std::array<Geometry, 2> rooms; ///< lit windows; uv in [0, 1] over each
};

/// `style`: 0 to kFacadeStyles - 1. `seed` decides which windows are lit.
Storey windowStorey(int style, uint32_t seed);

struct ShopStorey {
    Geometry wall;
    Geometry trim;
    Geometry frame;
    Geometry awning;
    std::array<Geometry, 4> windows; ///< of each side; uv in [0, 1]
    std::array<Geometry, 4> signs;   ///< boards above them, kSignAspect as wide as high; uv in [0, 1]
};

inline constexpr float kSignAspect = 8;
ShopStorey shopStorey(uint32_t seed);

struct Roof {
    Geometry cover; ///< and parapet
    Geometry plant; ///< air conditioning
    Geometry tank;
};

Roof flatRoof(uint32_t seed);

} // namespace glint::scene::builtin
