// The position of the picture in the window, and the picture point at a window point.
#pragma once

#include "lab/view/viewer_state.hpp"

namespace glint::view {

/// The picture fills the window. When zoomed in, the window shows a part of the picture.
struct Canvas {
    glm::vec2 windowPX = glm::vec2(1); ///< size in pixels
    glm::vec2 lowUV = glm::vec2(0);    ///< of the picture point at the window's top left
    glm::vec2 highUV = glm::vec2(1);

    glm::vec2 toUV(glm::vec2 px) const { return lowUV + px / windowPX * (highUV - lowUV); }
    glm::vec2 toPX(glm::vec2 uv) const { return (uv - lowUV) / (highUV - lowUV) * windowPX; }
};

Canvas makeCanvas(const Zoom& zoom, glm::uvec2 window);

/// Zooms by `factor`, limited to a total of [1, 256], so that the point under the mouse does not move.
Zoom zoomed(const Zoom& zoom, glm::uvec2 window, glm::vec2 mousePX, float factor);

} // namespace glint::view
