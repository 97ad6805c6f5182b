#include "lab/view/canvas.hpp"

#include <algorithm>

namespace glint::view {

Canvas makeCanvas(const Zoom& zoom, glm::uvec2 window) {
    const glm::vec2 half = glm::vec2(0.5f / zoom.factor);
    const glm::vec2 center = glm::clamp(zoom.centerUV, half, 1.0f - half);
    return {glm::max(glm::vec2(window), glm::vec2(1)), center - half, center + half};
}

Zoom zoomed(const Zoom& zoom, glm::uvec2 window, glm::vec2 mousePX, float factor) {
    const glm::vec2 uv = makeCanvas(zoom, window).toUV(mousePX);
    Zoom result;
    result.factor = std::clamp(zoom.factor * factor, 1.0f, 256.0f);
    const glm::vec2 share = mousePX / glm::max(glm::vec2(window), glm::vec2(1)) - 0.5f;
    const glm::vec2 half = glm::vec2(0.5f / result.factor);
    result.centerUV = glm::clamp(uv - share / result.factor, half, 1.0f - half);
    return result;
}

} // namespace glint::view
