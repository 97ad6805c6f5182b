#include "lab/scene/builtin/paint.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

uint8_t toByte(float value) {
    return static_cast<uint8_t>(std::lround(std::clamp(value, 0.f, 1.f) * 255.f));
}

/// IEC 61966-2-1.
float toSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

} // namespace

Image paint(const std::string& name, int size, bool srgb, const std::function<glm::vec3(const glm::vec2& uv)>& color) {
    Image image;
    image.name = name;
    image.width = image.height = static_cast<uint32_t>(size);
    image.rgba.reserve(static_cast<size_t>(size) * static_cast<size_t>(size) * 4);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(size);
            const glm::vec3 c = color(uv);
            for (int k = 0; k < 3; ++k)
                image.rgba.push_back(toByte(srgb ? toSrgb(c[k]) : c[k]));
            image.rgba.push_back(255);
        }
    }
    return image;
}

std::vector<float> heightsOf(int size, const std::function<float(const glm::vec2& uv)>& at) {
    std::vector<float> heights;
    heights.reserve(static_cast<size_t>(size) * static_cast<size_t>(size));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            heights.push_back(at((glm::vec2(x, y) + 0.5f) / static_cast<float>(size)));
    return heights;
}

TilePoint tileAt(const glm::vec2& uv, int tiles) {
    const glm::vec2 scaled = uv * static_cast<float>(tiles);
    const glm::vec2 cell = glm::floor(scaled);
    const glm::vec2 inside = scaled - cell;
    const glm::vec2 edge = glm::min(inside, 1.f - inside);
    return {static_cast<uint32_t>(cell.x), static_cast<uint32_t>(cell.y), inside, std::min(edge.x, edge.y)};
}

} // namespace glint::scene::builtin
