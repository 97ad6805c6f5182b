#include "lab/scene/builtin/turned.hpp"

#include "lab/scene/builtin/shapes.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace glint::scene::builtin {

namespace {

constexpr float kHeadRadius = 0.84f; ///< fraction of the foot radius: taper of the shaft

/// Unit direction of one column of a lattice around +Y; the last column repeats the first bit for bit.
glm::vec2 around(int column, int columns) {
    const float angle = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
    return {std::sin(angle), std::cos(angle)};
}

glm::vec2 segmentNormal(const glm::vec2& from, const glm::vec2& to) {
    const glm::vec2 along = to - from;
    return glm::normalize(glm::vec2(along.y, -along.x));
}

/// Appends points of an arc around `center`, from angle `from` to `to` (radians, 0 = outward, half pi = up).
void arc(std::vector<glm::vec2>& profile, const glm::vec2& center, float radius, float from, float to, int segments) {
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(segments));
        profile.push_back(center + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
}

/// Attic base: two rounded rings (torus) with a hollow between them.
Geometry columnBase(float radius, float bottom, float height) {
    const float lower = height * 0.24f, upper = height * 0.16f;
    std::vector<glm::vec2> profile = {{0, bottom}};
    arc(profile, {radius * 1.18f, bottom + lower}, lower, -glm::half_pi<float>(), glm::half_pi<float>(), 8);
    profile.emplace_back(radius * 1.12f, bottom + height * 0.54f);
    profile.emplace_back(radius * 1.12f, bottom + height * 0.62f);
    arc(profile, {radius * 1.06f, bottom + height * 0.62f + upper}, upper, -glm::half_pi<float>(),
        glm::half_pi<float>(), 8);
    profile.emplace_back(radius * 1.02f, bottom + height);
    profile.emplace_back(0.f, bottom + height);
    return lathe(profile, 40);
}

/// Doric capital: a necking ring, then the echinus, a cushion that swells towards the abacus.
Geometry columnCapital(float radius, float bottom, float height, float abacusRadius) {
    const float ring = height * 0.12f;
    std::vector<glm::vec2> profile = {{0, bottom}};
    arc(profile, {radius, bottom + ring}, ring, -glm::half_pi<float>(), glm::half_pi<float>(), 6);
    for (int i = 0; i <= 8; ++i) {
        const float t = static_cast<float>(i) / 8;
        const float swell = std::sin(t * glm::half_pi<float>());
        profile.emplace_back(glm::mix(radius, abacusRadius, swell), bottom + height * (0.3f + 0.7f * t * t));
    }
    profile.emplace_back(0.f, bottom + height);
    return lathe(profile, 40);
}

/// The shaft's outline as a function of angle and height; its normal comes from differences of the same function.
struct Shaft {
    ColumnShape shape;
    float bottom, height;

    float radius(float angle, float t) const {
        const float entasis = 1 - (1 - kHeadRadius) * std::pow(t, 1.8f);
        const float wave = 0.5f - 0.5f * std::cos(angle * static_cast<float>(shape.flutes));
        const float hollow = std::pow(wave, 0.7f); // broad hollows, narrow ridges
        const float fade = glm::smoothstep(0.f, 0.04f, t) * glm::smoothstep(0.f, 0.04f, 1 - t); // flutes run out
        return shape.radius * entasis * (1 - shape.fluteDepth * hollow * fade);
    }

    SurfacePoint point(int column, int columns, float t) const {
        constexpr float kStep = 1e-3f;
        const float angle = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
        const float r = radius(angle, t);
        const float slopeAround = (radius(angle + kStep, t) - radius(angle - kStep, t)) / (2 * kStep * r);
        const float above = std::min(t + kStep, 1.f), below = std::max(t - kStep, 0.f);
        const float slopeUp = (radius(angle, above) - radius(angle, below)) / ((above - below) * height);
        const glm::vec2 d = around(column, columns);
        const glm::vec3 normal = glm::normalize(glm::vec3(d.x, 0, d.y) - slopeAround * glm::vec3(d.y, 0, -d.x) -
                                                slopeUp * glm::vec3(0, 1, 0));
        return {{r * d.x, bottom + t * height, r * d.y},
                normal,
                {static_cast<float>(column) / static_cast<float>(columns), -t * height}};
    }
};

Geometry columnShaft(const Shaft& shaft) {
    const int columns = shaft.shape.flutes * shaft.shape.columnsPerFlute;
    const int rows = shaft.shape.rows;
    // Rows are denser at both ends, where the flutes run out.
    const auto height = [&](int row) {
        const float t = static_cast<float>(row) / static_cast<float>(rows);
        return row == rows ? 1.f : glm::mix(t, 0.5f - 0.5f * std::cos(glm::pi<float>() * t), 0.85f);
    };
    // Two more rows at either end close the shaft with a flat disc, hidden by base and capital: the rim again, then the
    // centre.
    return lattice(columns, rows + 4, [&](int column, int row) {
        SurfacePoint p = shaft.point(column, columns, height(std::clamp(row - 2, 0, rows)));
        if (row < 2 || row > rows + 2)
            p.normal = {0, row < 2 ? -1 : 1, 0};
        if (row == 0 || row == rows + 4)
            p.position = {0, p.position.y, 0};
        return p;
    });
}

} // namespace

Geometry lathe(std::span<const glm::vec2> profile, int columns) {
    constexpr float kCreaseCosine = 0.766f; // 40 degrees
    Geometry out;
    float along = 0;
    for (size_t i = 0; i + 1 < profile.size(); ++i) {
        const glm::vec2 ends[2] = {profile[i], profile[i + 1]};
        if (ends[0] == ends[1])
            continue;
        const glm::vec2 own = segmentNormal(ends[0], ends[1]);
        const auto smoothed = [&](size_t from, size_t to) {
            const glm::vec2 other = segmentNormal(profile[from], profile[to]);
            return glm::dot(own, other) > kCreaseCosine ? glm::normalize(own + other) : own;
        };
        glm::vec2 normals[2] = {i > 0 && profile[i - 1] != ends[0] ? smoothed(i - 1, i) : own,
                                i + 2 < profile.size() && profile[i + 2] != ends[1] ? smoothed(i + 1, i + 2) : own};
        const float length = glm::distance(ends[0], ends[1]);
        append(out, lattice(columns, 1, [&](int column, int row) {
                   const glm::vec2 d = around(column, columns), p = ends[row], n = normals[row];
                   return SurfacePoint{
                       {p.x * d.x, p.y, p.x * d.y},
                       {n.x * d.x, n.y, n.x * d.y},
                       {static_cast<float>(column) / static_cast<float>(columns), -(along + (row == 0 ? 0 : length))}};
               }));
        along += length;
    }
    computeTangents(out);
    return out;
}

Geometry cylinder(float radius, float height, int columns) {
    const std::array<glm::vec2, 4> profile = {glm::vec2(0, 0), {radius, 0}, {radius, height}, {0, height}};
    return lathe(profile, columns);
}

Geometry flutedColumn(const ColumnShape& shape) {
    const float plinth = shape.radius * 0.4f, base = shape.radius * 0.7f;
    const float capital = shape.radius * 0.75f, abacus = shape.radius * 0.4f;
    const float bottom = plinth + base, top = shape.height - abacus - capital;
    const float abacusHalf = shape.radius * 1.35f;
    const float overlap = 0.01f; // metres: the parts overlap, so no faces coincide

    Geometry out = columnShaft({shape, bottom - overlap, top - bottom + 2 * overlap});
    computeTangents(out);
    append(out, columnBase(shape.radius, plinth - overlap, base + overlap));
    append(out, columnCapital(shape.radius * kHeadRadius, top, capital + overlap, abacusHalf * 0.97f));
    append(out,
           translated(roundedBox({shape.radius * 1.5f, plinth / 2, shape.radius * 1.5f}, 0.012f), {0, plinth / 2, 0}));
    append(out,
           translated(roundedBox({abacusHalf, abacus / 2, abacusHalf}, 0.012f), {0, shape.height - abacus / 2, 0}));
    return out;
}

} // namespace glint::scene::builtin
