#include "reflect/prepare/blue_noise.hpp"

#include "shared/sample_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace glint::reflect {
namespace {

constexpr uint32_t kSize = shared::kBlueNoiseSize;
constexpr uint32_t kCount = kSize * kSize;
constexpr uint32_t kFirstPoints = kCount / 10; ///< points of the initial pattern

/// Density at each texel: a sum of Gaussians around the set points, wrapped around the tile's borders. In integers, so
/// that additions and removals are exact and every machine finds the same minima.
class Crowding {
public:
    Crowding() : density_(kCount, 0), isSet_(kCount, false) {
        constexpr double kSigma = 1.5; // Ulichney's, in texels
        for (uint32_t y = 0; y < kSize; ++y)
            for (uint32_t x = 0; x < kSize; ++x) {
                const double dx = std::min(x, kSize - x);
                const double dy = std::min(y, kSize - y);
                kernel_[y * kSize + x] =
                    static_cast<int64_t>(std::llround(std::exp(-(dx * dx + dy * dy) / (2 * kSigma * kSigma)) * 1e12));
            }
    }

    void set(uint32_t point, bool on) {
        const int64_t sign = on ? 1 : -1;
        const uint32_t px = point % kSize;
        const uint32_t py = point / kSize;
        for (uint32_t y = 0; y < kSize; ++y) {
            const int64_t* row = kernel_.data() + size_t{(y + kSize - py) % kSize} * kSize;
            int64_t* out = density_.data() + size_t{y} * kSize;
            for (uint32_t x = 0; x < kSize; ++x)
                out[x] += sign * row[(x + kSize - px) % kSize];
        }
        isSet_[point] = on;
    }
    bool isSet(uint32_t point) const { return isSet_[point]; }

    /// Returns the tightest cluster (densest set point) or the largest void (least dense unset point).
    uint32_t extreme(bool cluster) const {
        uint32_t best = kCount;
        for (uint32_t i = 0; i < kCount; ++i)
            if (isSet_[i] == cluster &&
                (best == kCount || (cluster ? density_[i] > density_[best] : density_[i] < density_[best])))
                best = i;
        return best;
    }

private:
    std::array<int64_t, kCount> kernel_ = {};
    std::vector<int64_t> density_;
    std::vector<bool> isSet_;
};

/// Ulichney 1993, "The Void-and-Cluster Method for Dither Array Generation". Ranks 0 to kCount - 1.
std::vector<uint32_t> voidAndCluster(uint64_t seed) {
    Crowding pattern;
    for (uint32_t i = 0; i < kFirstPoints;) {
        seed = seed * 6364136223846793005u + 1442695040888963407u; // Knuth, MMIX
        const uint32_t point = static_cast<uint32_t>(seed >> 40) % kCount;
        if (pattern.isSet(point))
            continue;
        pattern.set(point, true);
        ++i;
    }
    while (true) { // move the tightest cluster's point to the largest void, until they are the same
        const uint32_t cluster = pattern.extreme(true);
        pattern.set(cluster, false);
        const uint32_t hole = pattern.extreme(false);
        pattern.set(hole, true);
        if (hole == cluster)
            break;
    }
    std::vector<uint32_t> ranks(kCount, 0);
    Crowding shrinking = pattern;
    for (uint32_t rank = kFirstPoints; rank-- > 0;) {
        const uint32_t point = shrinking.extreme(true);
        shrinking.set(point, false);
        ranks[point] = rank;
    }
    // Past half the points Ulichney swaps set and unset; as the kernel's sum is the same at every texel, that changes
    // nothing.
    for (uint32_t rank = kFirstPoints; rank < kCount; ++rank) {
        const uint32_t point = pattern.extreme(false);
        pattern.set(point, true);
        ranks[point] = rank;
    }
    return ranks;
}

std::vector<uint32_t> makeMask() {
    const std::vector<uint32_t> low = voidAndCluster(1);
    const std::vector<uint32_t> high = voidAndCluster(2);
    std::vector<uint32_t> mask(kCount);
    constexpr uint32_t kStep = 65536 / kCount;
    for (uint32_t i = 0; i < kCount; ++i)
        mask[i] = low[i] * kStep | (high[i] * kStep) << 16;
    return mask;
}

} // namespace

std::span<const uint32_t> blueNoiseMask() {
    static const std::vector<uint32_t> kMask = makeMask();
    return kMask;
}

} // namespace glint::reflect
