#include "lab/scene/builtin/textures.hpp"

#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/paint.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// Veined stone at `p`, in units of about one vein spacing. Veins are zero crossings of a warped noise: thin lines
/// that meander and branch.
glm::vec3 stone(const glm::vec2& p, const StoneColors& colors, int period, uint32_t seed) {
    const glm::vec2 warp(fractalNoise(p, period, seed, 3), fractalNoise(p + 3.7f, period, seed + 17, 3));
    const glm::vec2 q = p + 0.6f * warp;
    const float cloud = 0.5f + 0.5f * fractalNoise(q, period, seed + 31, 4, 0.6f);
    const float broad = 1 - std::abs(noise(q, period, seed + 47));
    const float fine = 1 - std::abs(noise(2.f * q + 0.5f, 2 * period, seed + 59));
    const float vein =
        0.8f * std::pow(broad, 28.f) * glm::smoothstep(0.35f, 0.65f, cloud) + 0.35f * std::pow(fine, 40.f);
    return glm::mix(glm::mix(colors.ground, colors.cloud, cloud * cloud), colors.vein, std::min(vein, 1.f));
}

} // namespace

SurfaceImages stoneFloor(const std::string& name, const StoneFloor& floor) {
    constexpr int kNoPeriod = 1 << 16; // no period inside a tile; the image repeats by whole tiles
    constexpr uint32_t kSeed = 11;
    const float pixel = static_cast<float>(floor.tiles) / static_cast<float>(floor.size);
    const auto jointAt = [&](const TilePoint& tile) {
        return 1 - glm::smoothstep(floor.jointWidth / 2, floor.jointWidth / 2 + pixel, tile.edge);
    };
    SurfaceImages out;
    out.baseColor = paint(name + " colour", floor.size, true, [&](const glm::vec2& uv) {
        const TilePoint tile = tileAt(uv, floor.tiles);
        const StoneColors& colors = (tile.x + tile.y) % 2 == 0 ? floor.dark : floor.light;
        const glm::vec2 cutFrom(100 * hashUnit(tile.x, tile.y, 1), 100 * hashUnit(tile.x, tile.y, 2));
        const glm::vec2 turned =
            hashUnit(tile.x, tile.y, 3) < 0.5f ? tile.inside : glm::vec2(tile.inside.y, -tile.inside.x);
        const float tone = 0.8f + 0.4f * hashUnit(tile.x, tile.y, 4);
        return tone * stone(cutFrom + 1.6f * turned, colors, kNoPeriod, kSeed) * (1 - 0.7f * jointAt(tile));
    });
    out.metallicRoughness = paint(name + " roughness", floor.size, false, [&](const glm::vec2& uv) {
        const TilePoint tile = tileAt(uv, floor.tiles);
        const float patches = glm::smoothstep(0.f, 0.7f, fractalNoise(uv * 5.f, 5, kSeed + 90, 4));
        const float grain = 0.5f + 0.5f * fractalNoise(uv * 48.f, 48, kSeed + 95, 3);
        const float polish = floor.roughness + floor.smudge * patches * (0.6f + 0.4f * grain) +
                             0.02f * (hashUnit(tile.x, tile.y, 5) - 0.5f);
        return glm::vec3(0, glm::mix(polish, 0.6f, jointAt(tile)), 0);
    });
    return out;
}

Image marble(const std::string& name, int size, const StoneColors& colors, uint32_t seed) {
    return paint(name, size, true, [&](const glm::vec2& uv) { return stone(uv * 4.f, colors, 4, seed); });
}

Image checker(const std::string& name, int size, int squares, const glm::vec3& a, const glm::vec3& b) {
    const float pixel = static_cast<float>(squares) / static_cast<float>(size);
    return paint(name, size, true, [&](const glm::vec2& uv) {
        const TilePoint tile = tileAt(uv, squares);
        const float joint = 1 - glm::smoothstep(0.004f, 0.004f + pixel, tile.edge);
        return ((tile.x + tile.y) % 2 == 0 ? a : b) * (1 - 0.6f * joint);
    });
}

std::vector<float> blockHeights(int size, int columns, int rows, uint32_t seed) {
    return heightsOf(size, [&](const glm::vec2& uv) {
        const float row = std::floor(uv.y * static_cast<float>(rows));
        const float across = uv.x * static_cast<float>(columns) + (std::fmod(row, 2.f) == 0 ? 0.f : 0.5f);
        const glm::vec2 inside(across - std::floor(across), uv.y * static_cast<float>(rows) - row);
        // Distances to the block's edges in image widths, so that joints have the same width in both directions.
        const glm::vec2 edge = glm::min(inside, 1.f - inside) / glm::vec2(columns, rows);
        const float face = glm::smoothstep(0.f, 0.012f, std::min(edge.x, edge.y));
        return face * (0.85f + 0.15f * fractalNoise(uv * 24.f, 24, seed, 4));
    });
}

Image normalMap(const std::string& name, const std::vector<float>& heights, int size, float depth) {
    const auto at = [&](int x, int y) {
        return heights[static_cast<size_t>((y + size) % size) * static_cast<size_t>(size) +
                       static_cast<size_t>((x + size) % size)];
    };
    const float slopeScale = depth * static_cast<float>(size) / 2; // central differences, two pixels apart
    return paint(name, size, false, [&](const glm::vec2& uv) {
        const glm::ivec2 px(uv * static_cast<float>(size));
        const float slopeX = slopeScale * (at(px.x + 1, px.y) - at(px.x - 1, px.y));
        const float slopeUp = slopeScale * (at(px.x, px.y - 1) - at(px.x, px.y + 1)); // rows run down
        return 0.5f + 0.5f * glm::normalize(glm::vec3(-slopeX, -slopeUp, 1));
    });
}

Image blockColors(const std::string& name, const std::vector<float>& heights, int size, const glm::vec3& albedo,
                  uint32_t seed) {
    return paint(name, size, true, [&](const glm::vec2& uv) {
        const glm::ivec2 px(uv * static_cast<float>(size));
        const float height = heights[static_cast<size_t>(px.y) * static_cast<size_t>(size) + static_cast<size_t>(px.x)];
        const float stain = 1 + 0.25f * fractalNoise(uv * 6.f, 6, seed + 5, 4);
        return albedo * stain * glm::mix(0.45f, 1.f, std::min(height * 1.2f, 1.f));
    });
}

} // namespace glint::scene::builtin
