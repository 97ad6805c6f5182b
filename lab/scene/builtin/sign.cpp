#include "lab/scene/builtin/sign.hpp"

#include "lab/scene/builtin/sweep.hpp"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <vector>

namespace glint::scene::builtin {

namespace {

using Stroke = std::vector<glm::vec3>;

/// One letter, 1 high, from x = 0 to `width`.
struct Letter {
    float width = 0.4f;
    std::vector<Stroke> strokes;
};

constexpr float kBend = 0.09f;          ///< radius of a bent corner, of the letter's height
constexpr float kLetterSpacing = 0.34f; ///< between letters, of the letter's height

Stroke bent(std::initializer_list<glm::vec3> corners) {
    return roundedPolyline(std::span(corners.begin(), corners.size()), kBend);
}

/// An arc open to the right, then a bend and a bar to the middle: one tube.
Letter letterG() {
    constexpr int kSegments = 30;
    const float from = glm::radians(48.f), to = glm::radians(330.f);
    const glm::vec2 center(0.46f, 0.5f), radius(0.46f, 0.5f);
    Stroke stroke;
    for (int i = 0; i < kSegments; ++i) {
        const float angle = glm::mix(from, to, static_cast<float>(i) / kSegments);
        stroke.emplace_back(center + radius * glm::vec2(std::cos(angle), std::sin(angle)), 0);
    }
    const glm::vec3 arcEnd(center + radius * glm::vec2(std::cos(to), std::sin(to)), 0);
    const Stroke bar = bent({arcEnd, {0.92f, 0.5f, 0}, {0.5f, 0.5f, 0}});
    stroke.insert(stroke.end(), bar.begin(), bar.end());
    return {0.92f, {stroke}};
}

Letter letter(char c) {
    switch (c) {
    case 'G': return letterG();
    case 'L': return {0.52f, {bent({{0, 1, 0}, {0, 0, 0}, {0.52f, 0, 0}})}};
    case 'I': return {0, {{{0, 0, 0}, {0, 1, 0}}}};
    case 'N': return {0.68f, {bent({{0, 0, 0}, {0, 1, 0}, {0.68f, 0, 0}, {0.68f, 1, 0}})}};
    case 'T': return {0.72f, {{{0, 1, 0}, {0.72f, 1, 0}}, {{0.36f, 0, 0}, {0.36f, 1, 0}}}};
    default: return {};
    }
}

float textWidth(std::string_view text) {
    float width = -kLetterSpacing;
    for (const char c : text)
        width += letter(c).width + kLetterSpacing;
    return width;
}

} // namespace

Geometry neonText(std::string_view text, float height, float tubeRadius) {
    Geometry out;
    float x = -0.5f * textWidth(text);
    for (const char c : text) {
        const Letter shape = letter(c);
        for (Stroke stroke : shape.strokes) {
            for (glm::vec3& p : stroke)
                p = height * (p + glm::vec3(x, 0, 0));
            append(out, tube(stroke, tubeRadius));
        }
        x += shape.width + kLetterSpacing;
    }
    return out;
}

} // namespace glint::scene::builtin
