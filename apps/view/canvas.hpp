// Where the picture lies in the window, and what a point of the window shows of it.
#pragma once

#include "viewer_state.hpp"

namespace glint::view {

/// The picture fills the window; zoomed in, the window shows a part of it.
struct Canvas {
    glm::vec2 windowPX = glm::vec2(1); ///< size
    glm::vec2 lowUV = glm::vec2(0);    ///< of the picture, at the window's top left
    glm::vec2 highUV = glm::vec2(1);

    glm::vec2 toUV(glm::vec2 px) const { return lowUV + px / windowPX * (highUV - lowUV); }
    glm::vec2 toPX(glm::vec2 uv) const { return (uv - lowUV) / (highUV - lowUV) * windowPX; }
};

Canvas makeCanvas(const Zoom& zoom, glm::uvec2 window);

/// Zooms by `factor`, [1, 256] in all, so that the point under the mouse stays where it is.
Zoom zoomed(const Zoom& zoom, glm::uvec2 window, glm::vec2 mousePX, float factor);

} // namespace glint::view
