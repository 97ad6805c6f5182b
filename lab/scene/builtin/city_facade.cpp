#include "lab/scene/builtin/city_facade.hpp"

#include "lab/scene/builtin/noise.hpp"
#include "lab/scene/builtin/shapes.hpp"
#include "lab/scene/builtin/turned.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// A hole in a wall that lies in z = 0 and faces +Z: x and y from - to.
struct Opening {
    glm::vec2 from, to;
    float depth = 0.2f; ///< how far the window lies behind the wall

    glm::vec2 center() const { return (from + to) * 0.5f; }
    glm::vec2 half() const { return (to - from) * 0.5f; }
};

struct StyleShape {
    int bays = 1;    ///< on each side
    Opening opening; ///< in a bay, whose middle is x = 0
    int columns = 1; ///< panes
    int rows = 1;
    float lit = 0.3f; ///< share of the windows
    bool sill = false;
    bool lintel = false;
    bool pilaster = false;
    bool balcony = false;
    bool ledge = false;
};

constexpr std::array<StyleShape, kFacadeStyles> kStyles = {{
    {.bays = 6, .opening = {{-0.6f, 0.75f}, {0.6f, 2.65f}}, .columns = 2, .rows = 3, .sill = true, .lintel = true},
    {.bays = 5,
     .opening = {{-0.85f, 0.15f}, {0.85f, 2.6f}, 0.3f},
     .columns = 2,
     .rows = 2,
     .lit = 0.35f,
     .lintel = true,
     .balcony = true},
    {.bays = 5,
     .opening = {{-0.75f, 0.7f}, {0.75f, 2.7f}, 0.3f},
     .columns = 2,
     .rows = 2,
     .lit = 0.25f,
     .sill = true,
     .pilaster = true,
     .ledge = true},
    {.bays = 6,
     .opening = {{-1.42f, 0.25f}, {1.42f, 3.2f}, 0.08f},
     .columns = 3,
     .rows = 3,
     .lit = 0.5f,
     .ledge = true},
    {.bays = 4,
     .opening = {{-1.7f, 0.9f}, {1.7f, 2.6f}, 0.15f},
     .columns = 4,
     .lit = 0.35f,
     .sill = true,
     .lintel = true},
    {.bays = 7, .opening = {{-0.55f, 0.5f}, {0.55f, 2.8f}, 0.45f}, .rows = 2, .pilaster = true},
}};

void rectangle(Geometry& to, const glm::vec2& from, const glm::vec2& end, float z = 0) {
    appendQuad(
        to, {glm::vec3(from, z), glm::vec3(end.x, from.y, z), glm::vec3(end, z), glm::vec3(from.x, end.y, z)},
        {glm::vec2(from.x, -from.y), glm::vec2(end.x, -from.y), glm::vec2(end.x, -end.y), glm::vec2(from.x, -end.y)});
}

/// The same with uv from 0 to 1, for pictures.
void picture(Geometry& to, const glm::vec2& from, const glm::vec2& end, float z) {
    appendQuad(to, {glm::vec3(from, z), glm::vec3(end.x, from.y, z), glm::vec3(end, z), glm::vec3(from.x, end.y, z)},
               {glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0), glm::vec2(0, 0)});
}

void block(Geometry& to, const glm::vec3& center, const glm::vec3& half) {
    append(to, translated(box(half), center));
}

void softBlock(Geometry& to, const glm::vec3& center, const glm::vec3& half) {
    append(to, translated(roundedBox(half, 0.25f * std::min({half.x, half.y, half.z}), 1), center));
}

/// A wall of `half` width and `height` with a hole, and the hole's four inner faces.
void wallAround(Geometry& to, const Opening& hole, float half, float height) {
    rectangle(to, {-half, 0}, {hole.from.x, height});
    rectangle(to, {hole.to.x, 0}, {half, height});
    rectangle(to, {hole.from.x, 0}, {hole.to.x, hole.from.y});
    rectangle(to, {hole.from.x, hole.to.y}, {hole.to.x, height});
    const std::array<glm::vec2, 4> corners = {hole.from, {hole.to.x, hole.from.y}, hole.to, {hole.from.x, hole.to.y}};
    for (size_t i = 0; i < 4; ++i) {
        const glm::vec2 a = corners[i], b = corners[(i + 1) % 4];
        const float length = glm::distance(a, b), d = hole.depth;
        appendQuad(to, {glm::vec3(a, 0), glm::vec3(b, 0), glm::vec3(b, -d), glm::vec3(a, -d)},
                   {glm::vec2(0, 0), glm::vec2(length, 0), glm::vec2(length, -d), glm::vec2(0, -d)});
    }
}

/// Frame and bars of a window.
void casement(Geometry& to, const Opening& hole, int columns, int rows) {
    constexpr float kBar = 0.03f;
    const glm::vec2 half = hole.half(), center = hole.center();
    const float z = -hole.depth + 0.03f;
    append(to, translated(frame(half - 2 * kBar, 2 * kBar, 0.06f), glm::vec3(center, z)));
    for (int i = 1; i < columns; ++i)
        block(to, {glm::mix(hole.from.x, hole.to.x, static_cast<float>(i) / static_cast<float>(columns)), center.y, z},
              {kBar, half.y, 0.025f});
    for (int i = 1; i < rows; ++i)
        block(to, {center.x, glm::mix(hole.from.y, hole.to.y, static_cast<float>(i) / static_cast<float>(rows)), z},
              {half.x, kBar, 0.02f});
}

void balcony(Storey& to, float halfWidth) {
    constexpr float kDepth = 0.9f, kRail = 1.05f;
    softBlock(to.trim, {0, 0.05f, kDepth / 2}, {halfWidth, 0.08f, kDepth / 2});
    const Geometry bar = cylinder(0.014f, kRail - 0.1f, 6);
    const auto bars = [&](const glm::vec3& from, const glm::vec3& end, int count) {
        for (int i = 0; i <= count; ++i)
            append(to.frame, translated(bar, glm::mix(from, end, static_cast<float>(i) / static_cast<float>(count))));
    };
    const float x = halfWidth - 0.06f, z = kDepth - 0.06f;
    bars({-x, 0.12f, z}, {x, 0.12f, z}, 14);
    bars({-x, 0.12f, 0.1f}, {-x, 0.12f, z - 0.12f}, 5);
    bars({x, 0.12f, 0.1f}, {x, 0.12f, z - 0.12f}, 5);
    block(to.frame, {0, kRail, z}, {x + 0.03f, 0.025f, 0.03f});
    for (const float s : {-1.f, 1.f})
        block(to.frame, {s * x, kRail, z / 2}, {0.03f, 0.025f, z / 2});
}

/// `part` on the four sides of the building, from one side's middle in z = 0.
glm::mat4 onSide(int side, float x) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::half_pi<float>() * static_cast<float>(side), {0, 1, 0});
    return glm::translate(turn, {x, 0, kBuildingHalf});
}

void appendAt(Geometry& to, const Geometry& part, const glm::mat4& transform) {
    if (!part.positions.empty())
        append(to, transformed(part, transform));
}

} // namespace

Storey windowStorey(int style, uint32_t seed) {
    const StyleShape& shape = kStyles[static_cast<size_t>(style)];
    const float bayHalf = kBuildingHalf / static_cast<float>(shape.bays);
    const Opening& hole = shape.opening;
    Storey bay;
    wallAround(bay.wall, hole, bayHalf, kStoreyHeight);
    casement(bay.frame, hole, shape.columns, shape.rows);
    Geometry pane;
    picture(pane, hole.from, hole.to, -hole.depth);
    if (shape.sill)
        softBlock(bay.trim, {0, hole.from.y - 0.05f, 0.04f}, {hole.half().x + 0.1f, 0.05f, 0.12f});
    if (shape.lintel)
        softBlock(bay.trim, {0, hole.to.y + 0.12f, 0.01f}, {hole.half().x + 0.15f, 0.12f, 0.05f});
    if (shape.pilaster)
        softBlock(bay.trim, {bayHalf, kStoreyHeight / 2, 0.02f}, {0.16f, kStoreyHeight / 2, 0.1f});
    if (shape.ledge)
        softBlock(bay.trim, {0, kStoreyHeight - 0.06f, 0.05f}, {bayHalf, 0.09f, 0.14f});
    if (shape.balcony)
        balcony(bay, hole.half().x + 0.35f);

    Storey out;
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < shape.bays; ++i) {
            const float x = bayHalf * static_cast<float>(2 * i + 1 - shape.bays);
            const glm::mat4 place = onSide(side, x);
            appendAt(out.wall, bay.wall, place);
            appendAt(out.trim, bay.trim, place);
            appendAt(out.frame, bay.frame, place);
            const auto window = static_cast<uint32_t>(side * shape.bays + i);
            const bool lit = hashUnit(window, seed, 11) < shape.lit;
            appendAt(lit ? out.rooms[hash(window + seed * 97) % 2] : out.glass, pane, place);
        }
    }
    return out;
}

ShopStorey shopStorey(uint32_t seed) {
    constexpr float kDoorHalf = 0.6f;
    const Opening hole = {{-7.2f, 0.5f}, {5.2f, 3.0f}, -0.04f}; // the windows are flush with the wall
    const Opening door = {{6.1f, 0.02f}, {6.1f + 2 * kDoorHalf, 2.5f}, 0};
    ShopStorey out;
    for (int side = 0; side < 4; ++side) {
        Geometry wall, trim, bars, awning, window, sign;
        rectangle(wall, {-kBuildingHalf, 0}, {hole.from.x, kShopHeight});
        rectangle(wall, {hole.from.x, 0}, {hole.to.x, hole.from.y});
        rectangle(wall, {hole.from.x, hole.to.y}, {hole.to.x, kShopHeight});
        rectangle(wall, {hole.to.x, 0}, {kBuildingHalf, kShopHeight});
        softBlock(trim, {hole.center().x, hole.from.y, 0.03f}, {hole.half().x + 0.1f, 0.06f, 0.14f});
        softBlock(trim, {0, kShopHeight - 0.12f, 0.1f}, {kBuildingHalf + 0.15f, 0.14f, 0.22f});
        softBlock(trim, {-kBuildingHalf + 0.3f, kShopHeight / 2, 0.05f}, {0.28f, kShopHeight / 2, 0.1f});
        softBlock(trim, {kBuildingHalf - 0.3f, kShopHeight / 2, 0.05f}, {0.28f, kShopHeight / 2, 0.1f});
        picture(window, hole.from, hole.to, 0.02f);
        casement(bars, hole, 5, 1);
        block(bars, {door.center(), 0.03f}, {kDoorHalf, door.half().y, 0.04f});
        append(bars, translated(frame(door.half() - 0.12f, 0.12f, 0.12f), glm::vec3(door.center(), 0.04f)));
        const float signHalf = 0.36f;
        const float signX = -1.0f + 2 * (hashUnit(static_cast<uint32_t>(side), seed, 21) - 0.5f);
        picture(sign, {signX - signHalf * kSignAspect, 3.3f}, {signX + signHalf * kSignAspect, 3.3f + 2 * signHalf},
                0.16f);
        block(bars, {signX, 3.3f + signHalf, 0.08f}, {signHalf * kSignAspect + 0.05f, signHalf + 0.05f, 0.07f});
        if (hashUnit(static_cast<uint32_t>(side), seed, 22) < 0.6f) {
            constexpr int kFolds = 24; // a sloping cover with scalloped front
            append(awning, lattice(kFolds * 4, 3, [&](int column, int row) {
                       const float u = static_cast<float>(column) / (kFolds * 4), v = static_cast<float>(row) / 3;
                       const float wave = 0.03f * std::sin(u * glm::two_pi<float>() * kFolds) * (1 - v);
                       const glm::vec3 p(glm::mix(hole.from.x, hole.to.x, u), 2.65f + 0.5f * v + wave, 1.3f * (1 - v));
                       return SurfacePoint{p, glm::normalize(glm::vec3(0, 1.3f, 0.5f)), {u * kFolds, v}};
                   }));
        }
        const glm::mat4 place = onSide(side, 0);
        appendAt(out.wall, wall, place);
        appendAt(out.trim, trim, place);
        appendAt(out.frame, bars, place);
        appendAt(out.awning, awning, place);
        appendAt(out.windows[static_cast<size_t>(side)], window, place);
        appendAt(out.signs[static_cast<size_t>(side)], sign, place);
    }
    return out;
}

Roof flatRoof(uint32_t seed) {
    Roof out;
    block(out.cover, {0, 0.1f, 0}, {kBuildingHalf, 0.1f, kBuildingHalf});
    for (int side = 0; side < 4; ++side) {
        Geometry parapet;
        softBlock(parapet, {0, 0.5f, -0.05f}, {kBuildingHalf + 0.25f, 0.5f, 0.2f});
        appendAt(out.cover, parapet, onSide(side, 0));
    }
    for (uint32_t i = 0; i < 5; ++i) {
        const glm::vec3 at(-6.f + 12.f * hashUnit(i, seed, 31), 0.85f, -6.f + 12.f * hashUnit(i, seed, 32));
        softBlock(out.plant, at, {0.9f, 0.65f, 0.6f});
        append(out.plant, translated(cylinder(0.4f, 0.1f, 24), at + glm::vec3(0, 0.65f, 0)));
    }
    constexpr std::array<glm::vec2, 8> kTank = {
        {{0, 1.6f}, {1.5f, 1.6f}, {1.5f, 1.7f}, {1.45f, 1.7f}, {1.45f, 4.2f}, {1.6f, 4.25f}, {0.1f, 5.1f}, {0, 5.1f}}};
    const glm::vec3 at(4 - 8 * hashUnit(0, seed, 33), 0, 3);
    append(out.tank, translated(lathe(kTank, 32), at));
    for (const glm::vec2 leg : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
        append(out.tank, translated(cylinder(0.08f, 1.6f, 8), at + glm::vec3(leg.x, 0, leg.y)));
    return out;
}

} // namespace glint::scene::builtin
