// Vertices as hash table keys: compares bits, not nearly equal values.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string_view>

namespace glint::scene {

/// The bits of `N` floats or integers. 0 and -0 differ: add 0.0f to a float where they must be equal.
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
