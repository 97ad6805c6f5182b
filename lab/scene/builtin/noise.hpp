// Noise that is identical on every machine: an integer hash, and periodic gradient noise.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace glint::scene::builtin {

/// A well-mixed 32-bit hash (Jarzynski, Olano 2020, "Hash Functions for GPU Rendering": PCG).
inline uint32_t hash(uint32_t value) {
    const uint32_t state = value * 747796405u + 2891336453u;
    const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}
/// [0, 1).
float hashUnit(uint32_t x, uint32_t y, uint32_t seed);

/// Gradient noise in about [-1, 1], repeating every `period` units in both directions (Perlin 2002, "Improving Noise").
float noise(const glm::vec2& p, int period, uint32_t seed);

/// Sums octaves of `noise`: each has twice the frequency and `gain` times the amplitude of the previous one. About [-1,
/// 1], with the period of the first octave.
float fractalNoise(const glm::vec2& p, int period, uint32_t seed, int octaves, float gain = 0.5f);

} // namespace glint::scene::builtin
