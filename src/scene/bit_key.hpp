// Vertices as keys of hash tables: equal bits, not nearly equal values.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string_view>

namespace glint::scene {

/// `N` floats or integers by their bits. 0 and -0 are told apart: add 0.0f to a float where they must not be.
template <size_t N>
using BitKey = std::array<uint32_t, N>;

inline uint32_t bitsOf(float value) {
    return std::bit_cast<uint32_t>(value);
}

struct BitKeyHash {
    template <size_t N>
    size_t operator()(const BitKey<N>& key) const {
        return std::hash<std::string_view>()({reinterpret_cast<const char*>(key.data()), sizeof(key)});
    }
};

} // namespace glint::scene
