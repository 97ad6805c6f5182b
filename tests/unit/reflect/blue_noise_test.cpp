#include "reflect/prepare/blue_noise.hpp"

#include "shared/sample_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

namespace glint::reflect {
namespace blue_noise_test {

constexpr uint32_t kSize = shared::kBlueNoiseSize;

double channel(uint32_t texel, int which) {
    return (which == 0 ? texel & 0xffff : texel >> 16) / 65536.0 - 0.5;
}

/// Mean power of the waves with `low` to `high` periods across the tile, against white noise' of the same variance.
double power(int which, double low, double high) {
    double sum = 0;
    int waves = 0;
    for (int v = 0; v <= int(high); ++v)
        for (int u = -int(high); u <= int(high); ++u) {
            const double frequency = std::hypot(u, v);
            if (frequency < low || frequency > high || (v == 0 && u <= 0))
                continue;
            std::complex<double> amplitude = 0;
            for (uint32_t y = 0; y < kSize; ++y)
                for (uint32_t x = 0; x < kSize; ++x)
                    amplitude += channel(blueNoiseMask()[y * kSize + x], which) *
                                 std::polar(1.0, -2 * std::numbers::pi * (u * double(x) + v * double(y)) / kSize);
            sum += std::norm(amplitude);
            ++waves;
        }
    return sum / waves / (kSize * kSize / 12.0);
}

TEST(BlueNoise, HasNoLongWaves) {
    for (const int which : {0, 1}) {
        EXPECT_LT(power(which, 1, 8), 0.03);
        EXPECT_GT(power(which, 24, 30), 1);
    }
}

TEST(BlueNoise, RanksAreEvenAndIndependent) {
    std::set<uint32_t> low, high;
    double product = 0;
    for (const uint32_t texel : blueNoiseMask()) {
        low.insert(texel & 0xffff);
        high.insert(texel >> 16);
        product += channel(texel, 0) * channel(texel, 1);
    }
    EXPECT_EQ(low.size(), size_t{kSize} * kSize);
    EXPECT_EQ(high.size(), size_t{kSize} * kSize);
    EXPECT_LT(std::abs(product) / (kSize * kSize) * 12, 0.05) << "correlation";
}

} // namespace blue_noise_test
} // namespace glint::reflect
