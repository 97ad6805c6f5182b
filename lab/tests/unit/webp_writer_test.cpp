// What is written as WebP is read back by the decoder of textures.
#include "lab/scene/images/webp_writer.hpp"

#include "lab/scene/images/image_decode.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace glint::scene {
namespace webp_writer_test {

constexpr uint32_t kWidth = 19, kHeight = 7;

std::vector<uint8_t> gradient() {
    std::vector<uint8_t> rgb;
    for (uint32_t i = 0; i < kWidth * kHeight; ++i)
        rgb.insert(rgb.end(), {static_cast<uint8_t>(7 * i), static_cast<uint8_t>(i), 200});
    return rgb;
}

std::vector<uint8_t> readBack(const std::string& file) {
    const auto image = decodeImage({reinterpret_cast<const uint8_t*>(file.data()), file.size()}, "a.webp");
    EXPECT_TRUE(image) << image.error().message;
    std::vector<uint8_t> rgb;
    if (image && image->width == kWidth && image->height == kHeight)
        for (size_t i = 0; i < image->rgba.size(); ++i)
            if (i % 4 != 3)
                rgb.push_back(image->rgba[i]);
    return rgb;
}

TEST(WebpWriter, WithoutLossKeepsEveryByte) {
    const auto file = encodeWebp(kWidth, kHeight, gradient());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(readBack(*file), gradient());
}

TEST(WebpWriter, WithLossIsSmallerAndNear) {
    std::vector<uint8_t> rgb(3 * kWidth * kHeight);
    for (size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = static_cast<uint8_t>(100 + i % 57 / 3 + i * 31 % 4); // smooth, with a little noise
    const auto exact = encodeWebp(kWidth, kHeight, rgb), small = encodeWebp(kWidth, kHeight, rgb, 70.0f);
    ASSERT_TRUE(exact && small);
    EXPECT_LT(small->size(), exact->size());
    const std::vector<uint8_t> read = readBack(*small);
    ASSERT_EQ(read.size(), rgb.size());
    double sum = 0;
    for (size_t i = 0; i < rgb.size(); ++i)
        sum += std::abs(int(read[i]) - int(rgb[i]));
    EXPECT_LT(sum / static_cast<double>(rgb.size()), 8);
}

TEST(WebpWriter, SidesThatTheFormatLacksAreErrors) {
    const std::vector<uint8_t> row(3 * 16384);
    EXPECT_EQ(encodeWebp(16384, 1, row).error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(encodeWebp(0, 0, {}).error().code, ErrorCode::InvalidArgument);
}

} // namespace webp_writer_test
} // namespace glint::scene
