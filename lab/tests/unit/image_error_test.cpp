// Error figures against numbers worked out by hand.
#include "lab/measure/figures/image_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace glint::measure {
namespace image_error_test {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::vector<float> grey(std::initializer_list<float> values) {
    std::vector<float> rgba;
    for (const float value : values)
        rgba.insert(rgba.end(), {value, value, value, 1});
    return rgba;
}

TEST(Psnr, OfEqualPicturesIsInfinite) {
    EXPECT_EQ(psnr(grey({0.25f, 3}), grey({0.25f, 3})), std::numeric_limits<double>::infinity());
}

TEST(Psnr, IsTwentyDecibelsATenth) {
    EXPECT_NEAR(psnr(grey({0.5f}), grey({0.6f})), 20, 1e-5);
    EXPECT_NEAR(psnr(grey({0.5f}), grey({0.51f})), 40, 1e-4);
    EXPECT_NEAR(psnr(grey({0}), grey({1})), 0, 1e-9);
}

TEST(Psnr, AveragesOverPixelsAndColoursAndLeavesAlphaOut) {
    // One of six colours is off by 0.3: the mean squared error is 0.09 / 6.
    const std::vector<float> reference = {0.1f, 0.2f, 0.3f, 1, 0.4f, 0.5f, 0.6f, 1};
    const std::vector<float> test = {0.1f, 0.2f, 0.3f, 0, 0.4f, 0.8f, 0.6f, 0.5f};
    EXPECT_NEAR(psnr(reference, test), 10 * std::log10(6 / 0.09), 1e-5);
}

TEST(Psnr, ClampsToZeroAndOne) {
    EXPECT_EQ(psnr(grey({1, 0}), grey({50, -3})), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(psnr(grey({0.9f}), grey({7})), 20, 1e-5);
}

TEST(RelativeMse, IsZeroForEqualPictures) {
    EXPECT_EQ(relativeMse(grey({0.25f, 3}), grey({0.25f, 3})), 0);
}

TEST(RelativeMse, WeighsByTheReference) {
    EXPECT_NEAR(relativeMse(grey({1}), grey({1.5f})), 0.25 / 1.01, 1e-6);
    EXPECT_NEAR(relativeMse(grey({0}), grey({0.1f})), 1, 1e-6); // 0.1^2 / 0.01
    EXPECT_NEAR(relativeMse(grey({2, 0.5f}), grey({1, 0.6f})), (1 / 4.01 + 0.01 / 0.26) / 2, 1e-6);
    EXPECT_NE(relativeMse(grey({1}), grey({1.5f})), relativeMse(grey({1.5f}), grey({1})));
}

TEST(RelativeMse, ClampsToZeroAndSixteen) {
    EXPECT_EQ(relativeMse(grey({16, 0}), grey({60000, -1})), 0);
    EXPECT_NEAR(relativeMse(grey({8}), grey({1000})), 64 / 64.01, 1e-6);
    EXPECT_EQ(relativeMse(grey({16}), grey({std::numeric_limits<float>::infinity()})), 0);
}

TEST(ErrorMask, LeavesPixelsOut) {
    const std::vector<float> reference = grey({0, 0.5f, 1}), test = grey({1, 0.6f, kNaN});
    const std::array<uint8_t, 3> middle = {0, 255, 0}, none = {};
    EXPECT_NEAR(psnr(reference, test, middle), 20, 1e-5);
    EXPECT_NEAR(relativeMse(reference, test, middle), 0.01 / 0.26, 1e-6);
    EXPECT_EQ(relativeMse(reference, test, none), 0);
    EXPECT_EQ(psnr(reference, test, none), std::numeric_limits<double>::infinity());
}

TEST(ErrorFigures, ShowNaN) {
    EXPECT_TRUE(std::isnan(psnr(grey({0.5f, 1}), grey({0.5f, kNaN}))));
    EXPECT_TRUE(std::isnan(relativeMse(grey({kNaN, 1}), grey({0.5f, 1}))));
}

TEST(DisplayDifference, CountsPixelsNotChannels) {
    const std::vector<uint8_t> reference = {10, 20, 30, 40, 50, 60, 70, 80, 90, 0, 0, 0};
    const std::vector<uint8_t> test = {10, 20, 30, 45, 44, 66, 75, 80, 90, 0, 255, 0};
    const DisplayDifference difference = displayDifference({2, 2, reference}, {2, 2, test}, 5 / 255.0);
    EXPECT_EQ(difference.maxAbsDiff, 1);
    EXPECT_EQ(difference.failingPixels, 2u); // the second by 6, the fourth by 255; the third by just 5
    EXPECT_EQ(difference.failingFraction, 0.5);
}

TEST(DisplayDifference, MapHasTheLargestChannelOfEachPixel) {
    const std::vector<uint8_t> reference = {10, 20, 30, 40, 50, 60, 0, 0, 0};
    const std::vector<uint8_t> test = {10, 20, 30, 45, 44, 111, 0, 255, 0};
    EXPECT_EQ(displayDifferenceMap({3, 1, reference}, {3, 1, test}), (std::vector<float>{0, 0.2f, 1}));
}

TEST(DisplayDifference, OfEqualPicturesIsNone) {
    const std::vector<uint8_t> picture = {1, 2, 3, 250, 251, 252};
    const DisplayDifference difference = displayDifference({2, 1, picture}, {2, 1, picture}, 0);
    EXPECT_EQ(difference.maxAbsDiff, 0);
    EXPECT_EQ(difference.failingPixels, 0u);
}

TEST(DisplayDifference, AToleranceOfWholeBytesAllowsThem) {
    for (int bytes = 0; bytes < 255; ++bytes) {
        const std::vector<uint8_t> black(3), off = {0, static_cast<uint8_t>(bytes), 0};
        EXPECT_EQ(displayDifference({1, 1, black}, {1, 1, off}, bytes / 255.0).failingPixels, 0u) << bytes;
    }
}

TEST(WorstPixels, HoldTheirShareOfTheError) {
    // 2000 pixels: two are the worst thousandth. One is off by far, one that a display shows as white.
    std::vector<float> reference(4 * 2000, 0.5f);
    std::vector<float> test = reference;
    const auto set = [](std::vector<float>& image, size_t pixel, float value) {
        std::fill_n(image.begin() + static_cast<std::ptrdiff_t>(4 * pixel), 3, value);
    };
    for (size_t pixel = 100; pixel < 200; ++pixel)
        set(test, pixel, 0.6f);
    set(reference, 7, 1.5f);
    set(test, 7, 9.0f);
    set(test, 1234, 1.5f);
    const double small = 0.01 / 0.26, bright = 7.5 * 7.5 / 2.26, wide = 1.0 / 0.26, shown = 0.25 / 0.26;
    const WorstPixels radiance = worstPixels(relativeErrors(reference, test, kBrightestRelative));
    EXPECT_EQ(radiance.pixels, (std::vector<uint32_t>{7, 1234}));
    EXPECT_NEAR(radiance.share, (bright + wide) / (bright + wide + 100 * small), 1e-5);
    EXPECT_NEAR(radiance.mean, relativeMse(reference, test), 1e-9);
    const WorstPixels displayed = worstPixels(relativeErrors(reference, test, kDisplayWhite));
    EXPECT_EQ(displayed.pixels.front(), 1234u);
    EXPECT_NEAR(displayed.share, (shown + small) / (shown + 100 * small), 1e-5);
    EXPECT_EQ(worstPixels(relativeErrors(reference, reference, kDisplayWhite)).share, 0);
}

} // namespace image_error_test
} // namespace glint::measure
