#include "lab/session/settling.hpp"

#include "base/assert.hpp"

#include <bit>
#include <cmath>

namespace glint::render {
namespace {

double rootMeanSquare(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    uint64_t sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const int difference = a[i] - b[i];
        sum += static_cast<uint64_t>(difference * difference);
    }
    return a.empty() ? 0 : std::sqrt(static_cast<double>(sum) / static_cast<double>(a.size()));
}

} // namespace

/// Powers of two, and one and a half times those.
bool Settling::looksAfter(uint32_t frames) {
    return std::has_single_bit(frames) || (frames % 3 == 0 && std::has_single_bit(frames / 3));
}

bool Settling::settled(uint32_t frames, std::vector<uint8_t> rgb8) {
    const auto half = frames % 2 == 0 ? pictures_.find(frames / 2) : pictures_.end();
    if (half != pictures_.end()) {
        GLINT_ASSERT(half->second.size() == rgb8.size(), "pictures of one size");
        error_ = rootMeanSquare(half->second, rgb8);
        pictures_.erase(pictures_.begin(), std::next(half));
        if (error_ <= most_)
            return true;
    }
    pictures_.emplace(frames, std::move(rgb8));
    return false;
}

} // namespace glint::render
