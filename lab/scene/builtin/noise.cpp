#include "lab/scene/builtin/noise.hpp"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>

namespace glint::scene::builtin {

namespace {

/// A gradient for each of 64 hash values: avoids trigonometry in the inner loop.
const std::array<glm::vec2, 64>& gradients() {
    static const auto table = [] {
        std::array<glm::vec2, 64> directions;
        for (size_t i = 0; i < directions.size(); ++i) {
            const float angle = glm::two_pi<float>() * static_cast<float>(i) / 64;
            directions[i] = {std::cos(angle), std::sin(angle)};
        }
        return directions;
    }();
    return table;
}

/// Like %, but never negative.
int wrapped(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

/// std::floor is a call where the processor may lack an instruction for it, and takes half of the time of `noise`.
int floorOf(float value) {
    const int whole = static_cast<int>(value);
    return value < static_cast<float>(whole) ? whole - 1 : whole;
}

} // namespace

float hashUnit(uint32_t x, uint32_t y, uint32_t seed) {
    return static_cast<float>(hash(x + hash(y + hash(seed))) >> 8) * 0x1p-24f;
}

float noise(const glm::vec2& p, int period, uint32_t seed) {
    const glm::ivec2 cell(floorOf(p.x), floorOf(p.y));
    const glm::vec2 f = p - glm::vec2(cell);
    const int x0 = wrapped(cell.x, period), y0 = wrapped(cell.y, period);
    const int x1 = x0 + 1 == period ? 0 : x0 + 1, y1 = y0 + 1 == period ? 0 : y0 + 1;
    const std::array<glm::vec2, 64>& directions = gradients();
    const auto corner = [&](int x, uint32_t row, const glm::vec2& offset) {
        return glm::dot(directions[hash(static_cast<uint32_t>(x) + row) & 63], f - offset);
    };
    const uint32_t row0 = hash(static_cast<uint32_t>(y0) + seed), row1 = hash(static_cast<uint32_t>(y1) + seed);
    const glm::vec2 s = f * f * f * (f * (f * 6.f - 15.f) + 10.f);
    const float bottom = glm::mix(corner(x0, row0, {0, 0}), corner(x1, row0, {1, 0}), s.x);
    const float top = glm::mix(corner(x0, row1, {0, 1}), corner(x1, row1, {1, 1}), s.x);
    return 1.5f * glm::mix(bottom, top, s.y); // the raw range is about +-0.7
}

float fractalNoise(const glm::vec2& p, int period, uint32_t seed, int octaves, float gain) {
    float sum = 0, weight = 1, total = 0;
    glm::vec2 q = p;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * noise(q, period << i, seed + static_cast<uint32_t>(i));
        total += weight;
        weight *= gain;
        q *= 2.f;
    }
    return sum / total;
}

} // namespace glint::scene::builtin
