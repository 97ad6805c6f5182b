// A 64-bit hash of values in order, to detect changes. Not secure against deliberate collisions.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace glint {

/// FNV-1a (Fowler, Noll, Vo) over words of 8 bytes for speed, ending with the avalanche of MurmurHash3's finalizer.
class Hash {
public:
    Hash& bytes(const void* data, size_t size) {
        const auto* at = static_cast<const unsigned char*>(data);
        word(size); // so that bytes cannot move between neighbours
        for (; size >= 8; at += 8, size -= 8) {
            uint64_t value = 0;
            std::memcpy(&value, at, 8);
            word(value);
        }
        uint64_t rest = 0;
        if (size > 0) // the data pointer of an empty list may be null
            std::memcpy(&rest, at, size);
        word(rest);
        return *this;
    }
    Hash& text(std::string_view value) { return bytes(value.data(), value.size()); }
    /// Adds a number, or a struct without padding; its bytes are hashed.
    template <class T>
    Hash& value(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return bytes(&value, sizeof(value));
    }
    template <class T>
    Hash& list(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        return bytes(values.data(), values.size() * sizeof(T));
    }
    uint64_t result() const {
        uint64_t h = state_;
        h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdull;
        h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
        return h ^ (h >> 33);
    }

private:
    void word(uint64_t value) {
        state_ = (state_ ^ value) * 0x100000001b3ull;
        state_ ^= state_ >> 29; // the products of FNV carry upwards only
    }
    uint64_t state_ = 0xcbf29ce484222325ull;
};

} // namespace glint
