#include "lab/scene/builtin/paint.hpp"

#include "lab/scene/for_each_row.hpp"

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
    image.rgba.resize(size_t{4} * image.width * image.height);
    forEachRow(image.height, [&](uint32_t y) {
        uint8_t* out = image.rgba.data() + size_t{4} * image.width * y;
        for (uint32_t x = 0; x < image.width; ++x) {
            const glm::vec3 c = color((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
            for (int k = 0; k < 3; ++k)
                *out++ = toByte(srgb ? toSrgb(c[k]) : c[k]);
            *out++ = 255;
        }
    });
    return image;
}

std::vector<float> heightsOf(int size, const std::function<float(const glm::vec2& uv)>& at) {
    const auto side = static_cast<uint32_t>(size);
    std::vector<float> heights(size_t{side} * side);
    forEachRow(side, [&](uint32_t y) {
        for (uint32_t x = 0; x < side; ++x)
            heights[size_t{side} * y + x] = at((glm::vec2(x, y) + 0.5f) / static_cast<float>(size));
    });
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
