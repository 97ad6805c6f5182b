#include "lab/scene/builtin/shapes.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// A side's own axes: cross(right, up) = out.
struct SideAxes {
    glm::vec3 right, up, out;
};

SideAxes axesOf(Side side) {
    constexpr glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    switch (side) {
    case Side::PlusX: return {-z, y, x};
    case Side::MinusX: return {z, y, -x};
    case Side::PlusY: return {x, -z, y};
    case Side::MinusY: return {x, z, -y};
    case Side::PlusZ: return {x, y, z};
    case Side::MinusZ: break;
    }
    return {-x, y, -z};
}

/// Cut positions along one axis of a rounded box, from -half to half: dense where the rounding is.
std::vector<float> roundedCuts(float half, float radius, int segments) {
    std::vector<float> upper;
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::quarter_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
        upper.push_back(i == segments ? half : half - radius + radius * std::tan(angle)); // exact where faces meet
    }
    std::vector<float> cuts;
    for (auto it = upper.rbegin(); it != upper.rend(); ++it)
        cuts.push_back(-*it);
    cuts.insert(cuts.end(), upper.begin(), upper.end());
    return cuts;
}

glm::vec3 spherePoint(int column, int columns, int row, int rows) {
    if (row == 0 || row == rows)
        return {0, row == 0 ? -1.f : 1.f, 0};
    const float around = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
    const float up = glm::pi<float>() * (static_cast<float>(row) / static_cast<float>(rows) - 0.5f);
    return {std::sin(around) * std::cos(up), std::sin(up), std::cos(around) * std::cos(up)};
}

float cross2(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

bool insideTriangle(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
    return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

/// Ear clipping (Meisters 1975, "Polygons have ears"): a simple polygon has a corner that can be cut off; repeat.
std::vector<std::array<uint32_t, 3>> triangulate(std::span<const glm::vec2> outline) {
    std::vector<uint32_t> left(outline.size());
    for (uint32_t i = 0; i < left.size(); ++i)
        left[i] = i;
    const auto isEar = [&](size_t i) {
        const size_t n = left.size();
        const uint32_t before = left[(i + n - 1) % n], tip = left[i], after = left[(i + 1) % n];
        if (cross2(outline[tip] - outline[before], outline[after] - outline[tip]) <= 0)
            return false;
        return std::ranges::none_of(left, [&](uint32_t other) {
            return other != before && other != tip && other != after &&
                   insideTriangle(outline[other], outline[before], outline[tip], outline[after]);
        });
    };
    std::vector<std::array<uint32_t, 3>> triangles;
    while (left.size() > 2) {
        size_t ear = 0;
        while (ear + 1 < left.size() && !isEar(ear))
            ++ear;
        const size_t n = left.size();
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

void appendCap(Geometry& to, std::span<const glm::vec2> outline, float z, bool facesPlusZ) {
    const auto first = static_cast<uint32_t>(to.positions.size());
    for (const glm::vec2& p : outline) {
        to.positions.emplace_back(p, z);
        to.normals.emplace_back(0, 0, facesPlusZ ? 1 : -1);
        to.uvs[0].emplace_back(facesPlusZ ? p.x : -p.x, -p.y);
    }
    for (const auto& [a, b, c] : triangulate(outline)) {
        if (facesPlusZ)
            to.indices.insert(to.indices.end(), {first + a, first + b, first + c});
        else
            to.indices.insert(to.indices.end(), {first + a, first + c, first + b});
    }
}

} // namespace

Geometry boxSide(const glm::vec3& halfExtent, Side side) {
    const SideAxes axes = axesOf(side);
    const float right = std::abs(glm::dot(axes.right, halfExtent));
    const float up = std::abs(glm::dot(axes.up, halfExtent));
    const glm::vec3 middle = axes.out * halfExtent;
    Geometry out;
    appendQuad(out,
               {middle - axes.right * right - axes.up * up, middle + axes.right * right - axes.up * up,
                middle + axes.right * right + axes.up * up, middle - axes.right * right + axes.up * up},
               {glm::vec2(-right, up), glm::vec2(right, up), glm::vec2(right, -up), glm::vec2(-right, -up)});
    computeTangents(out);
    return out;
}

Geometry box(const glm::vec3& halfExtent) {
    Geometry out;
    for (const Side side : kAllSides)
        append(out, boxSide(halfExtent, side));
    return out;
}

Geometry roundedBox(const glm::vec3& halfExtent, float radius, int segments) {
    const glm::vec3 inner = halfExtent - radius;
    Geometry out;
    for (const Side side : kAllSides) {
        const SideAxes axes = axesOf(side);
        const auto alongRight = roundedCuts(std::abs(glm::dot(axes.right, halfExtent)), radius, segments);
        const auto alongUp = roundedCuts(std::abs(glm::dot(axes.up, halfExtent)), radius, segments);
        const int cells = 2 * segments + 1;
        append(out, lattice(cells, cells, [&](int column, int row) {
                   const float right = alongRight[static_cast<size_t>(column)], up = alongUp[static_cast<size_t>(row)];
                   // Clamp a point of the sharp box to the inner box, then offset it by the radius.
                   const glm::vec3 sharp = axes.out * halfExtent + axes.right * right + axes.up * up;
                   const glm::vec3 core = glm::clamp(sharp, -inner, inner);
                   const glm::vec3 normal = glm::normalize(sharp - core);
                   return SurfacePoint{core + radius * normal, normal, {right, -up}};
               }));
    }
    computeTangents(out);
    return out;
}

Geometry plane(const glm::vec2& halfExtent, int columns, int rows) {
    Geometry out = lattice(columns, rows, [&](int column, int row) {
        const glm::vec2 cell(static_cast<float>(column) / static_cast<float>(columns),
                             static_cast<float>(row) / static_cast<float>(rows));
        const glm::vec2 p = (cell * 2.f - 1.f) * halfExtent;
        return SurfacePoint{{p.x, 0, -p.y}, {0, 1, 0}, {p.x, -p.y}};
    });
    computeTangents(out);
    return out;
}

Geometry sphere(float radius, int columns, int rows) {
    return sphereSector(radius, columns, rows, 0, columns);
}

Geometry sphereSector(float radius, int columns, int rows, int firstColumn, int endColumn) {
    Geometry out = lattice(endColumn - firstColumn, rows, [&](int column, int row) {
        const int c = firstColumn + column;
        const glm::vec3 normal = spherePoint(c, columns, row, rows);
        return SurfacePoint{radius * normal,
                            normal,
                            {static_cast<float>(c) / static_cast<float>(columns),
                             1 - static_cast<float>(row) / static_cast<float>(rows)}};
    });
    computeTangents(out);
    return out;
}

Geometry torus(float radius, float tubeRadius, int columns, int rows) {
    Geometry out = lattice(columns, rows, [&](int column, int row) {
        const float u = static_cast<float>(column) / static_cast<float>(columns);
        const float v = static_cast<float>(row) / static_cast<float>(rows);
        const float around = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
        const float tube = glm::two_pi<float>() * static_cast<float>(row % rows) / static_cast<float>(rows);
        const glm::vec3 outward(std::cos(around), std::sin(around), 0);
        const glm::vec3 normal = outward * std::cos(tube) + glm::vec3(0, 0, std::sin(tube));
        return SurfacePoint{outward * radius + normal * tubeRadius, normal, {u, 1 - v}};
    });
    computeTangents(out);
    return out;
}

Geometry extrude(std::span<const glm::vec2> outline, float depth) {
    constexpr float kCreaseCosine = 0.82f; // 35 degrees: arcs of 24 segments are smooth, corners sharp
    const float half = depth / 2;
    Geometry out;
    appendCap(out, outline, half, true);
    appendCap(out, outline, -half, false);

    const size_t n = outline.size();
    const auto edgeNormal = [&](size_t i) {
        const glm::vec2 edge = outline[(i + 1) % n] - outline[i % n];
        return glm::normalize(glm::vec2(edge.y, -edge.x));
    };
    float along = 0;
    for (size_t i = 0; i < n; ++i) {
        const glm::vec2 own = edgeNormal(i), before = edgeNormal(i + n - 1), after = edgeNormal(i + 1);
        const glm::vec2 startNormal = glm::dot(own, before) > kCreaseCosine ? glm::normalize(own + before) : own;
        const glm::vec2 endNormal = glm::dot(own, after) > kCreaseCosine ? glm::normalize(own + after) : own;
        const float length = glm::distance(outline[i], outline[(i + 1) % n]);
        append(out, lattice(1, 1, [&](int column, int row) {
                   const glm::vec2 p = outline[row == 0 ? i : (i + 1) % n];
                   // Columns run from the front to the back, rows along the outline: the front side looks outward.
                   const float z = column == 0 ? half : -half;
                   return SurfacePoint{
                       {p, z}, {row == 0 ? startNormal : endNormal, 0}, {-z, -(along + (row == 0 ? 0 : length))}};
               }));
        along += length;
    }
    computeTangents(out);
    return out;
}

std::vector<glm::vec2> archOutline(float width, float height, float openingRadius, int segments) {
    std::vector<glm::vec2> outline = {{width / 2, 0}, {width / 2, height}, {-width / 2, height}, {-width / 2, 0}};
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::pi<float>() * (1 - static_cast<float>(i) / static_cast<float>(segments));
        const float y = i == 0 || i == segments ? 0 : std::sin(angle);
        outline.push_back(openingRadius * glm::vec2(std::cos(angle), y));
    }
    return outline;
}

std::vector<glm::vec2> starOutline(int points, float outerRadius, float innerRadius) {
    std::vector<glm::vec2> outline;
    for (int i = 0; i < 2 * points; ++i) {
        const float angle =
            glm::half_pi<float>() + glm::pi<float>() * static_cast<float>(i) / static_cast<float>(points);
        outline.push_back((i % 2 == 0 ? outerRadius : innerRadius) * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

Geometry frame(const glm::vec2& innerHalfExtent, float border, float depth) {
    constexpr std::array<glm::vec2, 4> signs = {glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(-1, -1)};
    Geometry out;
    for (size_t i = 0; i < 4; ++i) {
        const glm::vec2 from = signs[i], to = signs[(i + 1) % 4];
        const auto corner = [&](const glm::vec2& sign, bool outer, bool front) {
            return glm::vec3(sign * (innerHalfExtent + (outer ? border : 0.f)), front ? depth / 2 : -depth / 2);
        };
        const auto face = [&](bool outerA, bool frontA, bool outerB, bool frontB) {
            const float length = glm::distance(from * innerHalfExtent, to * innerHalfExtent) / 2 + border;
            const float width = outerA != outerB ? border : depth;
            appendQuad(
                out,
                {corner(from, outerA, frontA), corner(from, outerB, frontB), corner(to, outerB, frontB),
                 corner(to, outerA, frontA)},
                {glm::vec2(0, length), glm::vec2(width, length), glm::vec2(width, -length), glm::vec2(0, -length)});
        };
        face(false, true, true, true);   // front
        face(true, true, true, false);   // outside
        face(true, false, false, false); // back
        face(false, false, false, true); // inside
    }
    computeTangents(out);
    return out;
}

} // namespace glint::scene::builtin
