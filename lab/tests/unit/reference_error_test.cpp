// Errors against a reference, over all pixels and over mirrors, worked out by hand.
#include "lab/measure/truth/reference_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glint::measure {
namespace reference_error_test {

std::vector<float> grey(std::initializer_list<float> values) {
    std::vector<float> rgba;
    for (const float value : values)
        rgba.insert(rgba.end(), {value, value, value, 1});
    return rgba;
}

TEST(ReferenceError, CountsMirrorsApart) {
    // A mirror, one that is a little rough, one that is too rough, and a surface that reflects nothing.
    const ReferencePicture reference(grey({0.5f, 0.5f, 0.5f, 0.5f}), grey({0, kMirrorRoughness, 0.02f, 0}),
                                     grey({1, 0.04f, 1, 0}));
    const ReferenceError error = reference.errorOf(grey({0.5f, 0.4f, 0.5f, 0.3f}));
    EXPECT_EQ(error.mirrorPixels, 2u);
    EXPECT_NEAR(error.psnr, 10 * std::log10(4 / (0.01 + 0.04)), 1e-5);
    EXPECT_NEAR(error.psnrMirrors, 10 * std::log10(2 / 0.01), 1e-5);
    EXPECT_NEAR(error.relativeMse, (0.01 + 0.04) / 0.26 / 4, 1e-6);
    EXPECT_NEAR(error.relativeMseMirrors, 0.01 / 0.26 / 2, 1e-6);
}

TEST(ReferenceError, IsKnownByRoughness) {
    // A mirror, a glossy and two rough surfaces, and one that reflects nothing.
    const ReferencePicture reference(grey({0.5f, 0.5f, 0.5f, 0.5f, 0.5f}), grey({0, 0.2f, 0.5f, 1, 0}),
                                     grey({1, 0.04f, 1, 1, 0}));
    const ReferenceError error = reference.errorOf(grey({0.5f, 0.4f, 0.5f, 0.3f, 0}));
    const auto& bands = error.bands;
    EXPECT_EQ(bands[0].pixels, 1u);
    EXPECT_EQ(bands[0].relativeMse, 0);
    EXPECT_EQ(bands[1].pixels, 1u);
    EXPECT_NEAR(bands[1].relativeMse, 0.01 / 0.26, 1e-6);
    EXPECT_EQ(bands[2].pixels, 2u);
    EXPECT_NEAR(bands[2].relativeMse, 0.04 / 0.26 / 2, 1e-6);
    EXPECT_EQ(bands[kBands].pixels, 4u);
    EXPECT_NEAR(bands[kBands].relativeMse, 0.05 / 0.26 / 4, 1e-6);
}

} // namespace reference_error_test
} // namespace glint::measure
