#include "lab/cli/inspect/inspect_overlay.hpp"

#include "base/assert.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace glint::cli {
namespace {

using Color = glm::vec3; ///< as displayed, [0, 1]

constexpr Color kWhite = Color(1);
constexpr Color kBlack = Color(0);
constexpr Color kNothing = Color(0.95f, 0.2f, 0.15f);

Color colorOf(std::string_view decision) {
    const Float3 color = decisionColor(decision);
    return {color[0], color[1], color[2]};
}

/// Blends shapes with soft edges into an image.
class Canvas {
public:
    Canvas(uint32_t width, uint32_t height, std::span<uint8_t> rgb) : width_(width), height_(height), rgb_(rgb) {}

    void disc(glm::vec2 center, float radius, Color color, float opacity = 1) {
        shape(center - radius, center + radius, color, opacity,
              [&](glm::vec2 p) { return glm::distance(p, center) - radius; });
    }

    void ring(glm::vec2 center, float radius, float halfWidth, Color color) {
        shape(center - radius - halfWidth, center + radius + halfWidth, color, 1,
              [&](glm::vec2 p) { return std::abs(glm::distance(p, center) - radius) - halfWidth; });
    }

    void diamond(glm::vec2 center, float radius, Color color) {
        shape(center - radius, center + radius, color, 1, [&](glm::vec2 p) {
            const glm::vec2 d = glm::abs(p - center);
            return (d.x + d.y - radius) * 0.7071f;
        });
    }

    void line(glm::vec2 a, glm::vec2 b, float halfWidth, Color color, float opacity = 1) {
        const glm::vec2 along = b - a;
        const float length2 = std::max(glm::dot(along, along), 1e-12f);
        shape(glm::min(a, b) - halfWidth, glm::max(a, b) + halfWidth, color, opacity, [&](glm::vec2 p) {
            const float share = std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f);
            return glm::distance(p, a + share * along) - halfWidth;
        });
    }

    /// Draws the outline, inside the square.
    void square(glm::vec2 low, float side, float width, Color color, float opacity) {
        const glm::vec2 center = low + 0.5f * side;
        shape(low, low + side, color, opacity, [&](glm::vec2 p) {
            const glm::vec2 d = glm::abs(p - center) - 0.5f * side;
            const float inside = std::max(d.x, d.y);
            return std::max(inside, -inside - width);
        });
    }

private:
    /// `distance`: pixels to the shape's border, negative inside. The shape lies within [low, high].
    template <class Distance>
    void shape(glm::vec2 low, glm::vec2 high, Color color, float opacity, Distance&& distance) {
        const auto clampTo = [](float value, uint32_t size) {
            return static_cast<uint32_t>(std::clamp(value, 0.0f, static_cast<float>(size)));
        };
        const uint32_t right = clampTo(std::ceil(high.x) + 1, width_);
        const uint32_t bottom = clampTo(std::ceil(high.y) + 1, height_);
        for (uint32_t y = clampTo(std::floor(low.y) - 1, height_); y < bottom; ++y)
            for (uint32_t x = clampTo(std::floor(low.x) - 1, width_); x < right; ++x) {
                const glm::vec2 center = glm::vec2(x, y) + 0.5f;
                const float coverage = std::clamp(0.5f - distance(center), 0.0f, 1.0f) * opacity;
                if (coverage > 0)
                    blend(x, y, color, coverage);
            }
    }

    void blend(uint32_t x, uint32_t y, Color color, float coverage) {
        for (int c = 0; c < 3; ++c) {
            uint8_t& byte = rgb_[(size_t{y} * width_ + x) * 3 + static_cast<size_t>(c)];
            byte = static_cast<uint8_t>(std::lround(glm::mix(static_cast<float>(byte), color[c] * 255, coverage)));
        }
    }

    uint32_t width_;
    uint32_t height_;
    std::span<uint8_t> rgb_;
};

glm::vec2 toVec2(const Float2& v) {
    return {v[0], v[1]};
}

/// Clips the line, whose start is inside, to an image of this size less `margin`. Returns its end.
glm::vec2 lastInside(glm::vec2 start, glm::vec2 end, glm::vec2 size, float margin) {
    float share = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const float delta = end[axis] - start[axis];
        const float border = delta > 0 ? size[axis] - margin : margin;
        if (delta != 0)
            share = std::min(share, (border - start[axis]) / delta);
    }
    return start + (end - start) * std::max(share, 0.0f);
}

void drawCells(Canvas& canvas, const RayInspection& inspection, float unit) {
    for (const RaySample& sample : inspection.samples)
        if (sample.level > 0) {
            const float side = static_cast<float>(1u << sample.level);
            const glm::vec2 low = glm::floor(toVec2(sample.positionPX) / side) * side;
            canvas.square(low, side, 1.25f * unit, colorOf(sample.decision), 0.75f);
        }
}

void drawSamples(Canvas& canvas, const RayInspection& inspection, float unit) {
    const auto radius = [&](const RaySample& sample) {
        return (1.1f + 0.35f * static_cast<float>(std::min(sample.level, 8u))) * unit;
    };
    for (const RaySample& sample : inspection.samples)
        canvas.disc(toVec2(sample.positionPX), radius(sample) + 0.8f * unit, kBlack, 0.6f);
    for (const RaySample& sample : inspection.samples)
        canvas.disc(toVec2(sample.positionPX), radius(sample), colorOf(sample.decision));
}

void drawHit(Canvas& canvas, glm::vec2 at, float unit, Color color) {
    constexpr glm::vec2 kTicks[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const auto strokes = [&](float halfWidth, Color stroke) {
        canvas.ring(at, 6 * unit, halfWidth, stroke);
        for (const glm::vec2 tick : kTicks)
            canvas.line(at + tick * (6 * unit), at + tick * (10 * unit), halfWidth, stroke);
    };
    strokes(1.9f * unit, kBlack);
    strokes(1.0f * unit, color);
}

/// Draws the end of a ray without a hit, or the point where it left the image.
void drawEnd(Canvas& canvas, glm::vec2 at, float unit) {
    const auto strokes = [&](float halfWidth, Color stroke) {
        for (const float turn : {-1.0f, 1.0f}) {
            const glm::vec2 arm = glm::vec2(1, turn) * (5 * unit);
            canvas.line(at - arm, at + arm, halfWidth, stroke);
        }
    };
    strokes(1.9f * unit, kBlack);
    strokes(1.0f * unit, kNothing);
}

} // namespace

Float3 decisionColor(std::string_view decision) {
    constexpr std::pair<std::string_view, Float3> kColors[] = {
        {"front", {{0.35f, 0.75f, 1.0f}}},   {"behind", {{0.65f, 0.4f, 1.0f}}},   {"empty", {{0.6f, 0.65f, 0.7f}}},
        {"lookInto", {{1.0f, 0.85f, 0.2f}}}, {"passes", {{1.0f, 0.55f, 0.15f}}},  {"hit", {{0.2f, 0.95f, 0.3f}}},
        {"side", {{0.75f, 0.9f, 0.1f}}},     {"backFace", {{0.7f, 0.45f, 0.2f}}}, {"grazes", {{0.85f, 0.75f, 0.6f}}},
        {"nearly", {{1.0f, 0.35f, 0.9f}}},   {"places", {{1.0f, 1.0f, 1.0f}}},    {"inferred", {{0.75f, 1.0f, 0.8f}}},
        {"beside", {{0.6f, 0.8f, 0.7f}}},
    };
    for (const auto& [name, color] : kColors)
        if (name == decision)
            return color;
    return {1, 1, 1};
}

void drawRay(const RayInspection& inspection, uint32_t width, uint32_t height, std::span<uint8_t> rgb) {
    GLINT_ASSERT(rgb.size() == size_t{width} * height * 3, "{} bytes", rgb.size());
    Canvas canvas(width, height, rgb);
    const float unit = std::max(static_cast<float>(height) / 480, 0.6f);
    const glm::vec2 pixel = glm::vec2(inspection.pixel[0], inspection.pixel[1]) + 0.5f;
    if (!inspection.traced) {
        canvas.diamond(pixel, 6 * unit, kBlack);
        canvas.diamond(pixel, 4 * unit, kNothing);
        return;
    }
    const glm::vec2 start = toVec2(inspection.start.px);
    const glm::vec2 end = lastInside(start, toVec2(inspection.end.px), glm::vec2(width, height), 0);
    drawCells(canvas, inspection, unit);
    canvas.line(start, end, 1.6f * unit, kBlack, 0.6f);
    canvas.line(start, end, 0.7f * unit, kWhite);
    drawSamples(canvas, inspection, unit);
    canvas.diamond(start, 6 * unit, kBlack);
    canvas.diamond(start, 4 * unit, kWhite);
    if (inspection.answered)
        drawHit(canvas, end, unit, colorOf(inspection.outcome));
    else
        drawEnd(canvas, lastInside(start, end, glm::vec2(width, height), 5 * unit), unit);
}

} // namespace glint::cli
