// Letters as a neon bender draws them: strokes that become tubes.
#pragma once

#include "scene/builtin/mesh_tools.hpp"

#include <string_view>

namespace glint::scene::builtin {

/// A word as tubes in the plane z = 0, centred on x = 0 and standing on y = 0, `height` metres high. It reads from +Z.
/// Knows the letters G, I, L, N, T; others leave a gap.
Geometry neonText(std::string_view text, float height, float tubeRadius);

} // namespace glint::scene::builtin
