// FLIP: what the paper's formulas give by hand for flat pictures, what its authors' program gives for others, and what
// must hold for every picture.
#include "lab/measure/figures/flip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace glint::measure {
namespace flip_test {

using Color = std::array<int, 3>;

constexpr uint32_t kWidth = 64, kHeight = 48;

struct Picture {
    uint32_t width = kWidth;
    uint32_t height = kHeight;
    std::vector<uint8_t> rgb;

    operator DisplayPicture() const { return {width, height, rgb}; }
    Picture& set(uint32_t x, uint32_t y, const Color& color) {
        for (size_t c = 0; c < 3; ++c)
            rgb[3 * (size_t(y) * width + x) + c] = static_cast<uint8_t>(color[c]);
        return *this;
    }
};

Picture draw(const std::function<Color(int, int)>& colorAt, uint32_t width = kWidth, uint32_t height = kHeight) {
    Picture picture{width, height, std::vector<uint8_t>(size_t(width) * height * 3)};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            picture.set(x, y, colorAt(static_cast<int>(x), static_cast<int>(y)));
    return picture;
}

Picture flat(const Color& color, uint32_t width = kWidth, uint32_t height = kHeight) {
    return draw([&](int, int) { return color; }, width, height);
}

Picture gradient() {
    return draw([](int x, int y) { return Color{x * 4, y * 5, 255 - x * 4}; });
}
Picture checker() {
    return draw([](int x, int y) {
        const int v = (x / 4 + y / 4) % 2 == 1 ? 200 : 40;
        return Color{v, v / 2, 255 - v};
    });
}
Picture rings() {
    return draw([](int x, int y) {
        const int v = (x * x + 3 * y * y + x * y) % 251;
        return Color{v, v * 7 % 256, v * 13 % 256};
    });
}

/// Grey noise of +-amplitude, the same at every call.
Picture noisy(int amplitude) {
    return draw([&](int x, int y) {
        const uint32_t hash =
            (static_cast<uint32_t>(x) * 73856093u ^ static_cast<uint32_t>(y) * 19349663u) * 2654435761u;
        const int v = 128 + static_cast<int>(hash >> 16) % (2 * amplitude + 1) - amplitude;
        return Color{v, v, v};
    });
}

void expectEverywhere(const FlipMap& map, double expected, double within) {
    for (const float error : map.error)
        ASSERT_NEAR(error, expected, within);
    EXPECT_NEAR(map.mean, expected, within);
}

/// Andersson et al. 2020, section 4.1, for two flat colours: no filter changes them and no feature is there.
double mapped(double hyab) {
    const double largest = std::pow(203.30, 0.7); // green against blue, checked below
    const double error = std::pow(hyab, 0.7);
    return error < 0.4 * largest ? 0.95 / (0.4 * largest) * error
                                 : 0.95 + (error - 0.4 * largest) / (0.6 * largest) * 0.05;
}

double linearOf(double byte) {
    return byte / 255 <= 0.04045 ? byte / 255 / 12.92 : std::pow((byte / 255 + 0.055) / 1.055, 2.4);
}

/// CIE L* of a grey
double lightnessOf(double byte) {
    const double y = linearOf(byte);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27 * y;
}

TEST(Flip, EqualPicturesHaveNoError) {
    for (const Picture& picture : {gradient(), checker(), rings(), flat({0, 0, 0}), flat({255, 255, 255})}) {
        const FlipMap map = flip(picture, picture);
        EXPECT_EQ(map.mean, 0);
        EXPECT_TRUE(std::ranges::all_of(map.error, [](float error) { return error == 0; }));
    }
}

TEST(Flip, BlackAgainstWhiteIsAlmostAll) {
    // L* differs by 100 and greys have no chroma, so HyAB is 100.
    expectEverywhere(flip(flat({0, 0, 0}), flat({255, 255, 255})), mapped(100), 1e-5);
    EXPECT_NEAR(mapped(100), 0.9674, 1e-4);
}

TEST(Flip, GreenAgainstBlueIsAll) {
    expectEverywhere(flip(flat({0, 255, 0}), flat({0, 0, 255})), 1, 1e-6);
    // L*a*b* of the two: (87.74, -86.18, 83.18) and (32.30, 79.19, -107.86); a and b times L/100:
    const double a = -86.18 * 0.8774 - 79.19 * 0.3230, b = 83.18 * 0.8774 + 107.86 * 0.3230;
    EXPECT_NEAR(87.74 - 32.30 + std::sqrt(a * a + b * b), 203.30, 0.02);
}

TEST(Flip, GreysDifferByTheirLightness) {
    for (const auto& [one, other] : {std::pair(100, 120), std::pair(10, 30), std::pair(200, 255), std::pair(0, 1)}) {
        const double expected = mapped(lightnessOf(other) - lightnessOf(one));
        expectEverywhere(flip(flat({one, one, one}), flat({other, other, other})), expected, 1e-5);
    }
}

TEST(Flip, ColoursDifferByLightnessPlusChroma) {
    // sRGB (200, 30, 30) is linear (0.57758, 0.01298, 0.01298), L*a*b* (43.217, 63.041, 45.217); (200, 90, 30) has
    // linear green 0.10224 and L*a*b* (51.482, 40.671, 52.342). a and b times L/100, then HyAB.
    const double a = 63.041 * 0.43217 - 40.671 * 0.51482, b = 45.217 * 0.43217 - 52.342 * 0.51482;
    const double hyab = 51.482 - 43.217 + std::sqrt(a * a + b * b);
    expectEverywhere(flip(flat({200, 30, 30}), flat({200, 90, 30})), mapped(hyab), 1e-4);
}

// The authors' program (FLIP.h of 2025, C++, no GPU) on the same bytes.
TEST(Flip, AgreesWithTheAuthorsProgram) {
    EXPECT_NEAR(flip(gradient(), checker()).mean, 0.786523, 2e-6);
    EXPECT_NEAR(flip(gradient(), rings()).mean, 0.824286, 2e-6);
    EXPECT_NEAR(flip(checker(), rings(), 30).mean, 0.790895, 2e-6);
    EXPECT_NEAR(flip(checker(), rings(), 120).mean, 0.818636, 2e-6);
    EXPECT_NEAR(flip(gradient(), gradient().set(32, 24, {255, 255, 255})).mean, 0.001507, 2e-6);
}

TEST(Flip, OrderOfThePicturesDoesNotMatter) {
    EXPECT_EQ(flip(gradient(), rings()).error, flip(rings(), gradient()).error);
}

TEST(Flip, SameBitsAtEveryCall) {
    EXPECT_EQ(flip(checker(), rings()).error, flip(checker(), rings()).error);
}

TEST(Flip, GrowsWithTheNoise) {
    double last = 0;
    for (const int amplitude : {1, 2, 4, 8, 16, 32, 64, 120}) {
        const double mean = flip(flat({128, 128, 128}), noisy(amplitude)).mean;
        EXPECT_GT(mean, last) << amplitude;
        last = mean;
    }
}

TEST(Flip, MovesWithThePicture) {
    const auto dot = [](int x, int y) {
        Picture picture = flat({90, 90, 90});
        return picture.set(static_cast<uint32_t>(x), static_cast<uint32_t>(y), {255, 40, 0});
    };
    const FlipMap here = flip(flat({90, 90, 90}), dot(26, 20));
    const FlipMap there = flip(flat({90, 90, 90}), dot(31, 27));
    for (uint32_t y = 8; y < 34; ++y)
        for (uint32_t x = 12; x < 42; ++x)
            EXPECT_EQ(here.error[y * kWidth + x], there.error[(y + 7) * kWidth + x + 5]) << x << ' ' << y;
    EXPECT_EQ(std::ranges::max_element(here.error) - here.error.begin(), 20 * kWidth + 26);
}

TEST(Flip, FineDifferencesVanishWithDistance) {
    // One-pixel stripes of two greys against their mean light: at 67 pixels a degree lightness is blurred over some
    // three pixels; the stripes' edges stay detectable only near by.
    const Picture stripes = draw([](int x, int) { return x % 2 == 0 ? Color{140, 140, 140} : Color{115, 115, 115}; });
    const Picture grey = flat({128, 128, 128});
    EXPECT_GT(flip(grey, stripes, 10).mean, 4 * flip(grey, stripes, 67).mean);
}

TEST(Flip, ChangedFeaturesRaiseTheError) {
    // The same mean difference as a flat change and as a line.
    Picture line = flat({128, 128, 128});
    for (uint32_t y = 0; y < kHeight; ++y)
        line.set(kWidth / 2, y, {160, 160, 160});
    const FlipMap map = flip(flat({128, 128, 128}), line);
    const double onLine = map.error[kHeight / 2 * kWidth + kWidth / 2];
    EXPECT_GT(onLine, flip(flat({128, 128, 128}), flat({138, 138, 138})).mean); // filtered, the line is this bright
    EXPECT_EQ(map.error[kHeight / 2 * kWidth], 0);                              // far away, nothing
}

TEST(Flip, TakesPicturesSmallerThanItsFilters) {
    for (const auto& [width, height] : {std::pair(1u, 1u), std::pair(17u, 1u), std::pair(1u, 9u), std::pair(3u, 2u)})
        expectEverywhere(flip(flat({0, 0, 0}, width, height), flat({255, 255, 255}, width, height)), 0.9674, 1e-4);
}

TEST(ErrorColors, RiseFromBlackToPaleYellow) {
    const std::array<float, 6> values = {-1, 0, 0.5f, 1, 2, std::nanf("")};
    const std::vector<uint8_t> rgb = errorColors(values);
    EXPECT_EQ(rgb, (std::vector<uint8_t>{0, 0, 4, 0, 0, 4, 182, 54, 121, 252, 253, 191, 252, 253, 191, 0, 0, 4}));
    double last = -1;
    for (int i = 0; i <= 255; ++i) {
        const float value = static_cast<float>(i) / 255;
        const std::vector<uint8_t> color = errorColors({&value, 1});
        const double luminance =
            0.2126 * linearOf(color[0]) + 0.7152 * linearOf(color[1]) + 0.0722 * linearOf(color[2]);
        EXPECT_GE(luminance, last) << i;
        last = luminance;
    }
}

} // namespace flip_test
} // namespace glint::measure
