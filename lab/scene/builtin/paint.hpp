// Fills images and height fields by a formula.
#pragma once

#include "lab/scene/scene.hpp"

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace glint::scene::builtin {

/// Fills a square image of `size` pixels a side; the callback gets uv in [0, 1) at pixel centres, v from the top, and
/// returns linear values, from several threads at once. `srgb`: they are encoded as sRGB.
Image paint(const std::string& name, int size, bool srgb, const std::function<glm::vec3(const glm::vec2& uv)>& color);

/// Evaluates heights for `normalMap` at the same places, from several threads: size * size, rows from the top.
std::vector<float> heightsOf(int size, const std::function<float(const glm::vec2& uv)>& at);

/// The position of a point in a tiled image.
struct TilePoint {
    uint32_t x, y;    ///< which tile
    glm::vec2 inside; ///< [0, 1) within it
    float edge;       ///< distance to the nearest edge, of a tile
};

TilePoint tileAt(const glm::vec2& uv, int tiles);

} // namespace glint::scene::builtin
