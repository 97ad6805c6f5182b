// Pictures from memory: formats, depths, and files that lie about themselves.
#include "lab/scene/images/image_decode.hpp"

#include "lab/scene/images/jpeg_check.hpp"
#include "lab/tests/support/assets.hpp"
#include "lab/tests/support/png_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace glint::test {
namespace image_decode_test {

using testing::ElementsAre;
using testing::HasSubstr;

std::string errorOf(std::span<const uint8_t> bytes, uint64_t maxPixels = 1 << 20) {
    const auto image = scene::decodeImage(bytes, "a.png", maxPixels);
    return image ? "decoded" : image.error().message;
}

TEST(DecodeImage, EightBitRgbGetsAlpha) {
    const auto image = scene::decodeImage(pngFile(2, 1, 8, 2, {0, 10, 20, 30, 40, 50, 60}), "a.png");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->width, 2u);
    EXPECT_EQ(image->height, 1u);
    EXPECT_THAT(image->rgba, ElementsAre(10, 20, 30, 255, 40, 50, 60, 255));
}

TEST(DecodeImage, SixteenBitKeepsTheHighByte) {
    const auto image = scene::decodeImage(pngFile(1, 1, 16, 2, {0, 0x12, 0xFF, 0x34, 0x00, 0xFF, 0xFF}), "a.png");
    ASSERT_TRUE(image);
    EXPECT_THAT(image->rgba, ElementsAre(0x12, 0x34, 0xFF, 255));
}

TEST(DecodeImage, GreyWithAlphaBecomesRgba) {
    const auto image = scene::decodeImage(pngFile(1, 1, 8, 4, {0, 77, 128}), "a.png");
    ASSERT_TRUE(image);
    EXPECT_THAT(image->rgba, ElementsAre(77, 77, 77, 128));
}

TEST(DecodeImage, OneBitGrey) {
    const auto image = scene::decodeImage(pngFile(2, 1, 1, 0, {0, 0x40}), "a.png");
    ASSERT_TRUE(image);
    EXPECT_THAT(image->rgba, ElementsAre(0, 0, 0, 255, 255, 255, 255, 255));
}

TEST(DecodeImage, LosslessWebP) {
    // 1 x 1, (255, 0, 0, 255), made with cwebp -lossless.
    const std::vector<uint8_t> webp = {'R', 'I',  'F',  'F',  28,   0,    0,    0,    'W',  'E',  'B',  'P',
                                       'V', 'P',  '8',  'L',  15,   0,    0,    0,    0x2f, 0,    0,    0,
                                       0,   0x07, 0x10, 0xfd, 0x8f, 0xfe, 0x07, 0x22, 0xa2, 0xff, 0x01, 0};
    const auto image = scene::decodeImage(webp, "a.webp");
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_THAT(image->rgba, ElementsAre(255, 0, 0, 255));
}

TEST(DecodeImage, OtherFormatsAreNamedAsSuch) {
    const std::string text = "not a picture";
    EXPECT_EQ(errorOf({reinterpret_cast<const uint8_t*>(text.data()), text.size()}),
              "a.png: is no PNG, JPEG or WebP image");
    EXPECT_EQ(errorOf({}), "a.png: is no PNG, JPEG or WebP image (0 bytes)");
    const std::string ktx = "\xabKTX 20\xbb\r\n\x1a\n....";
    const auto image = scene::decodeImage({reinterpret_cast<const uint8_t*>(ktx.data()), ktx.size()}, "a.ktx2");
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::Unsupported);
}

TEST(DecodeImage, LimitsHoldBeforePixelsAreMade) {
    EXPECT_EQ(errorOf(pngFile(2000, 1000, 8, 2, {0})),
              "a.png: is 2000 x 1000 pixels; at most 16384 a side and 1048576 in all can be read");
    EXPECT_THAT(errorOf(pngFile(20000, 1, 8, 2, {0})), HasSubstr("a.png: "));
    EXPECT_THAT(errorOf(pngFile(1024, 1024, 8, 2, {0})), HasSubstr("more than its 69 bytes can hold"));
}

TEST(DecodeImage, EveryCutIsAnErrorOrAPicture) {
    const std::vector<uint8_t> whole = pngFile(2, 2, 8, 2, {0, 1, 2, 3, 4, 5, 6, 0, 7, 8, 9, 10, 11, 12});
    for (size_t size = 0; size < whole.size() - 12; ++size) // the last chunk, IEND, is empty
        EXPECT_NE(errorOf(std::span(whole).first(size)), "decoded") << size;
}

TEST(JpegTables, MoreThan256CodesAreRefused) {
    std::vector<uint8_t> jpeg = {0xFF, 0xD8, 0xFF, 0xC4, 0x00, 0x00, 0x00};
    const size_t tables = jpeg.size();
    jpeg.insert(jpeg.end(), 16, 17); // 272 codes
    jpeg.insert(jpeg.end(), 272, 0);
    const size_t length = jpeg.size() - 4;
    jpeg[4] = static_cast<uint8_t>(length >> 8);
    jpeg[5] = static_cast<uint8_t>(length);
    EXPECT_FALSE(scene::jpegTablesFit(jpeg));
    EXPECT_EQ(errorOf(jpeg), "a.png: the JPEG's tables are damaged or cut off");

    std::fill_n(jpeg.begin() + long(tables), 16, uint8_t(16)); // 256 codes, but then 16 bytes are left over
    EXPECT_FALSE(scene::jpegTablesFit(jpeg));
    jpeg[5] = static_cast<uint8_t>(length - 16);
    EXPECT_TRUE(scene::jpegTablesFit(jpeg));
}

TEST(JpegTables, FoundBetweenScans) {
    // Picture data with a stuffed 0xFF and a restart marker, then a table that claims 272 codes.
    std::vector<uint8_t> jpeg = {0xFF, 0xD8, 0xFF, 0xDA, 0,    2,    1, 0xFF, 0, 2,
                                 0xFF, 0xD0, 3,    0xFF, 0xFF, 0xC4, 1, 35,   0};
    jpeg.insert(jpeg.end(), 16, 17);
    jpeg.insert(jpeg.end(), 272, 0);
    EXPECT_FALSE(scene::jpegTablesFit(jpeg));
}

TEST(JpegTables, RealFilesPass) {
    GLINT_NEED_ASSET(path, "models/LightsPunctualLamp/glTF/material0_emissive.jpeg");
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    const std::span<const uint8_t> view(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    EXPECT_TRUE(scene::jpegTablesFit(view));
    EXPECT_TRUE(scene::decodeImage(view, "a.jpeg"));
}

} // namespace image_decode_test
} // namespace glint::test
