// Image files: what goes out comes back, and whatever comes in, the answer is a picture or one line.
#include "lab/scene/images/image_file.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace glint::scene {
namespace image_file_test {

constexpr uint64_t kMaxPixels = 1 << 20;

std::string radianceHeader(std::string_view size) {
    return "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\n\n" + std::string(size) + "\n";
}

/// A one-line error that begins with the name.
template <class T>
void expectError(const Result<T>& result, std::string_view name, std::string_view part) {
    ASSERT_FALSE(result.ok());
    const std::string& message = result.error().message;
    EXPECT_EQ(message.substr(0, name.size() + 2), std::string(name) + ": ");
    EXPECT_NE(message.find(part), message.npos) << message;
    EXPECT_TRUE(std::ranges::none_of(message, [](char c) { return static_cast<unsigned char>(c) < 0x20; })) << message;
    EXPECT_LT(message.size(), 400u);
}

class ImageFileTest : public testing::Test {
protected:
    std::string write(const std::string& name, std::string_view bytes) const {
        EXPECT_TRUE(writeFile(folder_ + name, bytes).ok());
        return folder_ + name;
    }
    const test::TempFolder temp_;
    const std::string& folder_ = temp_.path();
};

// ---------------------------------------------------------------- Radiance

TEST(Radiance, FlatPixelsAreMantissasTimesTwoToTheExponent) {
    const auto image = decodeRadiance(radianceHeader("-Y 1 +X 2") + std::string("\x80\x40\x20\x81\xff\xff\xff\x00", 8),
                                      "a.hdr", kMaxPixels);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->rgb[0], glm::vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(image->rgb[1], glm::vec3(0)); // exponent 0 is black, whatever the mantissas
}

TEST(Radiance, NewRunLengths) {
    std::string row("\x02\x02\x00\x08", 4);
    row += "\x88\x80";                              // red: eight times 128
    row += "\x04\x01\x02\x03\x04\x84\x05";          // green: four literals, four times 5
    row += std::string("\x88\x00", 2) + "\x88\x81"; // blue 0, exponent 129
    const auto image = decodeRadiance(radianceHeader("-Y 1 +X 8") + row, "a.hdr", kMaxPixels);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->rgb[0], glm::vec3(1, 1 / 128.0f, 0));
    EXPECT_EQ(image->rgb[3], glm::vec3(1, 4 / 128.0f, 0));
    EXPECT_EQ(image->rgb[7], glm::vec3(1, 5 / 128.0f, 0));
}

TEST(Radiance, OldRunLengthsCountInHigherBytes) {
    std::string pixels("\x80\x80\x80\x81", 4);
    pixels += std::string("\x01\x01\x01\x2b\x01\x01\x01\x01", 8); // 43 + 256 repeats
    const auto image = decodeRadiance(radianceHeader("-Y 1 +X 300") + pixels, "a.hdr", kMaxPixels);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_TRUE(std::ranges::all_of(image->rgb, [](const glm::vec3& p) { return p == glm::vec3(1); }));
}

TEST(Radiance, SignsOfTheSizeFlip) {
    const std::string pixels("\x80\0\0\x81\0\x80\0\x81\0\0\x80\x81\x80\x80\x80\x81", 16); // red, green; blue, white
    const glm::vec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1);
    const std::pair<std::string_view, std::vector<glm::vec3>> cases[] = {{"-Y 2 +X 2", {red, green, blue, white}},
                                                                         {"+Y 2 +X 2", {blue, white, red, green}},
                                                                         {"-Y 2 -X 2", {green, red, white, blue}},
                                                                         {"+Y 2 -X 2", {white, blue, green, red}}};
    for (const auto& [size, expected] : cases) {
        const auto image = decodeRadiance(radianceHeader(size) + pixels, "a.hdr", kMaxPixels);
        ASSERT_TRUE(image.ok()) << image.error().message;
        EXPECT_EQ(image->rgb, expected) << size;
    }
}

TEST(Radiance, HugeRadianceStaysFiniteAndIsNotCutToWhatAHalfHolds) {
    const auto image = decodeRadiance(radianceHeader("-Y 1 +X 1") + "\xff\x01\x80\xff", "a.hdr", kMaxPixels);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->rgb[0], glm::vec3(1e12f));
    const auto sun = decodeRadiance(radianceHeader("-Y 1 +X 1") + "\x80\x80\x80\x93", "a.hdr", kMaxPixels);
    ASSERT_TRUE(sun.ok());
    EXPECT_EQ(sun->rgb[0], glm::vec3(262144));
}

TEST(Radiance, BrokenHeadersAreErrors) {
    const std::pair<std::string, std::string_view> cases[] = {
        {"", "header is truncated"},
        {"#?RADIANCE", "header is truncated"},
        {"#?RADIANCE\n\n", "header is truncated"},
        {"P6\n\n-Y 1 +X 1\n", "does not begin with #?"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n", "32-bit_rle_xyze is not supported"},
        {"#?" + std::string(100000, 'x'), "header is truncated"},
        {radianceHeader("-Y 0 +X 1"), "expected a size"},
        {radianceHeader("-Y -1 +X 1"), "expected a size"},
        {radianceHeader("-Y 1"), "expected a size"},
        {radianceHeader("+X 1 -Y 1"), "expected a size"},
        {radianceHeader("-Y 1 +X 1 2"), "expected a size"},
        {radianceHeader("-Y 99999999999 +X 1"), "expected a size"},
        {radianceHeader("-Y 4000000000 +X 4000000000"), "too many"},
        {radianceHeader("-Y 16384 +X 16384"), "too many"},
        {radianceHeader("-Y 1 +X 16385"), "too many"},
    };
    for (const auto& [bytes, part] : cases)
        expectError(decodeRadiance(bytes, "a.hdr", kMaxPixels), "a.hdr", part);
}

TEST(Radiance, BrokenRowsAreErrorsThatNameTheRow) {
    const std::string pixel("\x80\x80\x80\x81", 4);
    const std::pair<std::string, std::string_view> cases[] = {
        {radianceHeader("-Y 2 +X 1") + pixel, "row 2 of 2"},
        {radianceHeader("-Y 1 +X 2") + pixel + "abc", "row 1 of 1"},
        {radianceHeader("-Y 1 +X 2") + "\x01\x01\x01\x01" + pixel, "row 1 of 1"},         // nothing to repeat
        {radianceHeader("-Y 1 +X 2") + pixel + "\x01\x01\x01\x02", "row 1 of 1"},         // repeats past the row's end
        {radianceHeader("-Y 1 +X 8") + std::string("\x02\x02\x00\x09", 4), "row 1 of 1"}, // another row's length
        {radianceHeader("-Y 1 +X 8") + std::string("\x02\x02\x00\x08\x89\x80", 6), "row 1 of 1"}, // run too long
        {radianceHeader("-Y 1 +X 8") + std::string("\x02\x02\x00\x08\x00\x80", 6), "row 1 of 1"}, // run of none
        {radianceHeader("-Y 1 +X 8") + std::string("\x02\x02\x00\x08\x08\x80", 6), "row 1 of 1"}, // bytes missing
    };
    for (const auto& [bytes, part] : cases)
        expectError(decodeRadiance(bytes, "a.hdr", kMaxPixels), "a.hdr", part);
}

TEST(Radiance, EveryTruncationIsAnError) {
    std::string row("\x02\x02\x00\x08", 4);
    row += "\x88\x80\x04\x01\x02\x03\x04\x84\x05" + std::string("\x88\x00", 2) + "\x88\x81";
    const std::string bytes = radianceHeader("-Y 2 +X 8") + row + row;
    ASSERT_TRUE(decodeRadiance(bytes, "a.hdr", kMaxPixels).ok());
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(decodeRadiance(std::string_view(bytes).substr(0, length), "a.hdr", kMaxPixels).ok()) << length;
}

// ---------------------------------------------------------------- OpenEXR

TEST_F(ImageFileTest, ExrRoundTripsInFloatAndNearlyInHalf) {
    const uint32_t width = 5, height = 3;
    std::vector<float> rgba;
    for (uint32_t i = 0; i < width * height * 4; ++i)
        rgba.push_back(0.1f * float(i));
    for (const bool half : {false, true}) {
        const ExrLayer layer{"", "RGBA", half, rgba, 4};
        ASSERT_TRUE(writeExr(folder_ + "a.exr", width, height, {&layer, 1}).ok());
        const auto image = readHdrImage(folder_ + "a.exr");
        ASSERT_TRUE(image.ok()) << image.error().message;
        ASSERT_EQ(image->width, width);
        ASSERT_EQ(image->height, height);
        for (size_t i = 0; i < image->rgb.size(); ++i) {
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image->rgb[i][c], rgba[i * 4 + c], half ? rgba[i * 4 + c] / 1024 : 0.0f);
        }
    }
}

TEST_F(ImageFileTest, ExrTakesTheColorOfALayerWhereNoneIsBare) {
    const std::vector<float> depth = {1, 2}, color = {1, 2, 3, 4, 5, 6};
    const ExrLayer layers[] = {{"depth", "Z", false, depth, 1}, {"reflection", "RGB", false, color, 3}};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 2, 1, layers).ok());
    const auto image = readHdrImage(folder_ + "a.exr");
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->rgb, (std::vector<glm::vec3>{{1, 2, 3}, {4, 5, 6}}));

    ASSERT_TRUE(writeExr(folder_ + "b.exr", 2, 1, {layers, 1}).ok());
    expectError(readHdrImage(folder_ + "b.exr"), folder_ + "b.exr", "no R, G and B channels; it has depth.Z");
}

TEST_F(ImageFileTest, ExrRadianceIsFiniteAndNotNegative) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> color = {inf, -1, std::numeric_limits<float>::quiet_NaN()};
    const ExrLayer layer{"", "RGB", false, color, 3};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 1, 1, {&layer, 1}).ok());
    const auto image = readHdrImage(folder_ + "a.exr");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->rgb[0], glm::vec3(kMaxRadiance, 0, 0));
}

TEST_F(ImageFileTest, ExrHalvesAreClampedNotInfinite) {
    const std::vector<float> color = {1e9f, 65519, 1};
    const ExrLayer layer{"", "RGB", true, color, 3};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 1, 1, {&layer, 1}).ok());
    EXPECT_EQ(readHdrImage(folder_ + "a.exr")->rgb[0], glm::vec3(kMaxRadiance, kMaxRadiance, 1)); // halves in the file
}

TEST_F(ImageFileTest, ExrOfTheSamePixelsIsTheSameBytes) {
    const std::vector<float> color(64 * 64 * 3, 0.25f);
    const ExrLayer layer{"", "RGB", true, color, 3};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 64, 64, {&layer, 1}).ok());
    ASSERT_TRUE(writeExr(folder_ + "b.exr", 64, 64, {&layer, 1}).ok());
    EXPECT_EQ(*readFile(folder_ + "a.exr", 1 << 20), *readFile(folder_ + "b.exr", 1 << 20));
}

TEST_F(ImageFileTest, ExrWithOneChannelTwiceIsRefused) {
    const std::vector<float> color(4, 0.0f);
    const ExrLayer layers[] = {{"", "RGB", false, color, 4}, {"", "RGBA", false, color, 4}};
    EXPECT_EQ(writeExr(folder_ + "a.exr", 1, 1, layers).error().message,
              folder_ + "a.exr: two layers have the channel R");
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(ImageFileTest, EveryTruncationOfAnExrIsAnError) {
    std::vector<float> color;
    for (int i = 0; i < 40 * 40 * 3; ++i)
        color.push_back(float(i % 97));
    const ExrLayer layer{"", "RGB", false, color, 3};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 40, 40, {&layer, 1}).ok());
    const std::string bytes = *readFile(folder_ + "a.exr", 1 << 20);
    for (size_t length = 0; length < bytes.size(); length += 7)
        expectError(decodeExr(std::string_view(bytes).substr(0, length), "a.exr", kMaxPixels), "a.exr", "");
}

TEST_F(ImageFileTest, ExrWithFlippedBytesIsAPictureOrAnError) {
    const std::vector<float> color(16 * 16 * 3, 0.5f);
    const ExrLayer layer{"", "RGB", true, color, 3};
    ASSERT_TRUE(writeExr(folder_ + "a.exr", 16, 16, {&layer, 1}).ok());
    const std::string bytes = *readFile(folder_ + "a.exr", 1 << 20);
    for (size_t i = 0; i < bytes.size(); ++i) {
        std::string broken = bytes;
        broken[i] = static_cast<char>(~broken[i]);
        const auto image = decodeExr(broken, "a.exr", kMaxPixels);
        if (!image.ok())
            expectError(image, "a.exr", "");
    }
}

// ---------------------------------------------------------------- any file

TEST_F(ImageFileTest, FilesThatAreNoPicturesAreErrors) {
    expectError(readHdrImage(write("empty.hdr", "")), folder_ + "empty.hdr", "the file is empty");
    expectError(readHdrImage(write("text.hdr", "hello\n")), folder_ + "text.hdr", "neither a Radiance");
    expectError(readHdrImage(write("short.exr", "\x76\x2f\x31\x01")), folder_ + "short.exr", "truncated");
    expectError(readHdrImage(folder_ + "none.hdr"), folder_ + "none.hdr", "No such file");
    expectError(readHdrImage(folder_), folder_, "Is a directory");
}

TEST_F(ImageFileTest, ContentDecidesNotTheName) {
    const std::string path = write("really_radiance.exr", radianceHeader("-Y 1 +X 1") + "\x80\x80\x80\x81");
    ASSERT_TRUE(readHdrImage(path).ok());
}

// ---------------------------------------------------------------- PNG

TEST_F(ImageFileTest, PngHasItsSignatureSizeAndColorType) {
    for (const uint32_t channels : {3u, 4u}) {
        const std::vector<uint8_t> pixels(7 * 5 * channels, 200);
        ASSERT_TRUE(writePng(folder_ + "a.png", 7, 5, channels, pixels).ok());
        const std::string bytes = *readFile(folder_ + "a.png", 1 << 20);
        EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\x07\0\0\0\x05", 8));
        EXPECT_EQ(bytes[24], 8);                     // bits
        EXPECT_EQ(bytes[25], channels == 3 ? 2 : 6); // RGB, RGBA
        ASSERT_TRUE(writePng(folder_ + "b.png", 7, 5, channels, pixels).ok());
        EXPECT_EQ(*readFile(folder_ + "b.png", 1 << 20), bytes);
    }
}

TEST_F(ImageFileTest, WritingIntoAFolderThatIsNotThereIsAnError) {
    const std::vector<uint8_t> pixel = {1, 2, 3};
    const std::vector<float> color = {1, 2, 3};
    const ExrLayer layer{"", "RGB", false, color, 3};
    expectError(writePng(folder_ + "none/a.png", 1, 1, 3, pixel), folder_ + "none/a.png", "No such file");
    expectError(writeExr(folder_ + "none/a.exr", 1, 1, {&layer, 1}), folder_ + "none/a.exr", "No such file");
}

} // namespace image_file_test
} // namespace glint::scene
