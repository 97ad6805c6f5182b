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
    return ((value % period) + period) % period;
}

} // namespace

uint32_t hash(uint32_t value) {
    const uint32_t state = value * 747796405u + 2891336453u;
    const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

float hashUnit(uint32_t x, uint32_t y, uint32_t seed) {
    return static_cast<float>(hash(x + hash(y + hash(seed))) >> 8) * 0x1p-24f;
}

float noise(const glm::vec2& p, int period, uint32_t seed) {
    const glm::vec2 cell = glm::floor(p), f = p - cell;
    const int x0 = wrapped(static_cast<int>(cell.x), period), y0 = wrapped(static_cast<int>(cell.y), period);
    const int x1 = wrapped(x0 + 1, period), y1 = wrapped(y0 + 1, period);
    const auto corner = [&](int x, int y, const glm::vec2& offset) {
        const uint32_t h = hash(static_cast<uint32_t>(x) + hash(static_cast<uint32_t>(y) + seed));
        return glm::dot(gradients()[h & 63], f - offset);
    };
    const glm::vec2 s = f * f * f * (f * (f * 6.f - 15.f) + 10.f);
    const float bottom = glm::mix(corner(x0, y0, {0, 0}), corner(x1, y0, {1, 0}), s.x);
    const float top = glm::mix(corner(x0, y1, {0, 1}), corner(x1, y1, {1, 1}), s.x);
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
