#include "lab/scene/builtin/city_textures.hpp"

#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/paint.hpp"

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// [0, 1]: 1 where water stands.
float water(const glm::vec2& uv, uint32_t seed, float low, float high) {
    return glm::smoothstep(low, high, 0.5f + 0.5f * fractalNoise(uv * 5.f, 5, seed, 4));
}

} // namespace

GroundImages wetAsphalt(int size) {
    constexpr uint32_t kSeed = 301;
    const auto wet = [](const glm::vec2& uv) { return water(uv, kSeed, 0.42f, 0.6f); };
    const auto grain = [](const glm::vec2& uv) { return fractalNoise(uv * 96.f, 96, kSeed + 1, 2); };
    GroundImages out;
    out.surface.baseColor = paint("asphalt colour", size, true, [&](const glm::vec2& uv) {
        const float stains = 1 + 0.3f * fractalNoise(uv * 9.f, 9, kSeed + 2, 3);
        return glm::vec3(0.028f, 0.029f, 0.032f) * stains * (1 + 0.5f * grain(uv)) * (1 - 0.5f * wet(uv));
    });
    out.surface.metallicRoughness = paint("asphalt roughness", size, false, [&](const glm::vec2& uv) {
        return glm::vec3(0, glm::mix(0.4f + 0.08f * grain(uv), 0.03f, wet(uv)), 0);
    });
    out.normal = normalMap(
        "asphalt normals",
        heightsOf(size, [&](const glm::vec2& uv) { return 0.5f + 0.5f * grain(uv) * (1 - wet(uv)); }), size, 0.0012f);
    return out;
}

GroundImages wetPavement(int size) {
    constexpr uint32_t kSeed = 401;
    constexpr int kSlabs = 4;
    const auto joint = [&](const TilePoint& slab) { return 1 - glm::smoothstep(0.012f, 0.03f, slab.edge); };
    const auto wet = [](const glm::vec2& uv) { return water(uv, kSeed, 0.5f, 0.72f); };
    GroundImages out;
    out.surface.baseColor = paint("pavement colour", size, true, [&](const glm::vec2& uv) {
        const TilePoint slab = tileAt(uv, kSlabs);
        const float tone = 0.8f + 0.4f * hashUnit(slab.x, slab.y, kSeed);
        return glm::vec3(0.16f, 0.155f, 0.145f) * tone * (1 + 0.2f * fractalNoise(uv * 24.f, 24, kSeed + 3, 3)) *
               (1 - 0.7f * joint(slab)) * (1 - 0.4f * wet(uv));
    });
    out.surface.metallicRoughness = paint("pavement roughness", size, false, [&](const glm::vec2& uv) {
        return glm::vec3(0, glm::mix(glm::mix(0.5f, 0.1f, wet(uv)), 0.6f, joint(tileAt(uv, kSlabs))), 0);
    });
    out.normal =
        normalMap("pavement normals",
                  heightsOf(size, [&](const glm::vec2& uv) { return 1 - joint(tileAt(uv, kSlabs)); }), size, 0.002f);
    return out;
}

Image litRoom(const std::string& name, int size, uint32_t seed) {
    const float curtain = 0.12f + 0.16f * hashUnit(seed, 0, 1);
    const glm::vec2 lamp(0.3f + 0.4f * hashUnit(seed, 0, 2), 0.15f + 0.3f * hashUnit(seed, 0, 3));
    const float shelf = 0.55f + 0.2f * hashUnit(seed, 0, 4);
    const bool blind = hashUnit(seed, 0, 5) < 0.4f;
    return paint(name, size, true, [&](const glm::vec2& uv) {
        const float side = std::min(uv.x, 1 - uv.x);
        if (side < curtain) { // in folds
            const float fold = 0.6f + 0.4f * std::sin(uv.x * 90.f + 0.5f * fractalNoise(uv * 4.f, 4, seed, 2));
            return glm::vec3(0.34f, 0.2f, 0.11f) * fold;
        }
        if (blind && uv.y < 0.45f)
            return glm::vec3(0.45f, 0.4f, 0.32f) * (std::fmod(uv.y * 24.f, 1.f) < 0.15f ? 0.4f : 1.f);
        const float glow = 1 / (1 + 14 * glm::dot(uv - lamp, uv - lamp));
        glm::vec3 color = glm::vec3(0.75f, 0.62f, 0.45f) * (0.25f + 0.75f * glow);
        const auto book = static_cast<uint32_t>(uv.x * 14.f);
        if (uv.y > shelf && uv.y < shelf + 0.25f && hashUnit(book, seed, 6) < 0.6f)
            color *= glm::vec3(0.2f + 0.5f * hashUnit(book, seed, 7), 0.25f, 0.2f + 0.3f * hashUnit(book, seed, 8));
        return color;
    });
}

Image shopWindow(const std::string& name, int size, uint32_t seed) {
    constexpr int kShelves = 3, kGoods = 22;
    return paint(name, size, true, [&](const glm::vec2& uv) {
        const glm::vec2 p = uv * glm::vec2(kGoods, kShelves);
        const glm::uvec2 cell(p);
        const glm::vec2 inside = p - glm::vec2(cell);
        const float lamp = std::abs(std::fmod(uv.x * 5.f, 1.f) - 0.5f); // over each pane
        const float light = (0.2f + 0.5f * std::exp(-3 * uv.y)) * (1 - lamp) + 0.12f * std::exp(-5 * inside.y);
        const glm::vec3 wall = glm::vec3(0.9f, 0.8f, 0.62f) * light;
        if (inside.y > 0.95f)
            return wall * 0.2f; // the shelf
        const uint32_t kind = seed * 128 + cell.y * kGoods + cell.x;
        const float height = 0.3f + 0.45f * hashUnit(kind, 0, 1), width = 0.35f + 0.5f * hashUnit(kind, 0, 2);
        const float across = std::abs(inside.x - 0.5f) / (0.5f * width), up = (1 - inside.y) / height;
        const bool bottle = hashUnit(kind, 0, 6) < 0.4f;
        if (up > 1 || across > (bottle && up > 0.7f ? 0.35f : 1.f) || hashUnit(kind, 0, 7) < 0.15f)
            return wall * 0.55f;
        const glm::vec3 goods(hashUnit(kind, 0, 3), hashUnit(kind, 0, 4), hashUnit(kind, 0, 5));
        const float label = std::abs(up - 0.45f) < 0.12f ? 0.7f : 0.f;
        return glm::mix(0.06f + 0.7f * goods * goods, glm::vec3(0.8f), label) * (light + 0.1f) *
               (1 - 0.4f * across * across);
    });
}

Image signBoard(const std::string& name, int size, float aspect, uint32_t seed, const glm::vec3& ground,
                const glm::vec3& letters) {
    constexpr float kRows = 7, kColumns = 5, kMargin = 1.5f; // of a letter's grid
    const float cell = (kRows + 2 * kMargin);
    const float count = std::floor((aspect * cell - 2 * kMargin) / (kColumns + 1));
    return paint(name, size, true, [&](const glm::vec2& uv) {
        const glm::vec2 p = uv * glm::vec2(aspect, 1) * cell; // in cells of the grid, rows from the top
        const glm::vec2 edge = glm::min(p, glm::vec2(aspect, 1) * cell - p);
        if (const float rim = std::min(edge.x, edge.y); rim > 0.3f && rim < 0.7f)
            return letters;
        const glm::vec2 q = p - kMargin;
        const float letter = std::floor(q.x / (kColumns + 1));
        const glm::vec2 dot(std::floor(q.x) - letter * (kColumns + 1), std::floor(q.y));
        if (letter < 0 || letter >= count || dot.y < 0 || dot.y >= kRows || dot.x >= kColumns)
            return ground;
        // Strokes at the sides, and at top, middle and bottom: each letter has some of them.
        const auto has = [&](uint32_t stroke) { return hashUnit(static_cast<uint32_t>(letter), seed, stroke) < 0.62f; };
        const bool upper = dot.y < kRows / 2;
        const bool on = (dot.x == 0 && (has(1) || upper)) || (dot.x == kColumns - 1 && has(upper ? 2 : 3)) ||
                        (dot.y == 0 && has(4)) || (dot.y == 3 && has(5)) || (dot.y == kRows - 1 && has(6));
        return on ? letters : ground;
    });
}

Image leaves(const std::string& name, int size, uint32_t seed) {
    constexpr uint32_t kLeaves = 26;
    /// How far inside the nearest leaf, [0, 1] from its rim to its middle; negative outside.
    const auto inside = [&](const glm::vec2& uv) {
        float best = -1;
        for (uint32_t i = 0; i < kLeaves; ++i) {
            const glm::vec2 center(0.14f + 0.72f * hashUnit(i, seed, 1), 0.14f + 0.72f * hashUnit(i, seed, 2));
            const float angle = 6.2831853f * hashUnit(i, seed, 3);
            const glm::vec2 axis(std::cos(angle), std::sin(angle));
            const glm::vec2 d = uv - center;
            const glm::vec2 along(glm::dot(d, axis) / 0.11f, (d.y * axis.x - d.x * axis.y) / 0.05f);
            best = std::max(best, 1 - glm::dot(along, along));
        }
        return best;
    };
    Image image = paint(name, size, true, [&](const glm::vec2& uv) {
        const float tone = 0.6f + 0.4f * fractalNoise(uv * 12.f, 12, seed, 3);
        return glm::vec3(0.05f, 0.12f, 0.025f) * tone * (0.6f + 0.4f * std::max(inside(uv), 0.f));
    });
    for (size_t i = 0; i < image.rgba.size() / 4; ++i) {
        const auto px = static_cast<int>(i);
        const glm::vec2 uv = (glm::vec2(px % size, px / size) + 0.5f) / static_cast<float>(size);
        image.rgba[i * 4 + 3] = inside(uv) > 0 ? 255 : 0;
    }
    return image;
}

} // namespace glint::scene::builtin
