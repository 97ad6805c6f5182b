// Letters of a neon sign: strokes that become tubes.
#pragma once

#include "lab/scene/builtin/mesh_tools.hpp"

#include <string_view>

namespace glint::scene::builtin {

/// A word as tubes in the plane z = 0, centred on x = 0 and standing on y = 0, `height` metres high, readable from +Z.
/// Supports the letters G, I, L, N, T; other letters leave a gap.
Geometry neonText(std::string_view text, float height, float tubeRadius);

} // namespace glint::scene::builtin
