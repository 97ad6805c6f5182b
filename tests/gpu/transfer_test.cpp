// Upload and download: every format that is read back, mips and layers, and errors.
#include "gpu/support/gpu_test.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <random>

namespace glint::test {
namespace transfer_test {

using testing::HasSubstr;

constexpr VkFormat kFormats[] = {
    VK_FORMAT_R8_UNORM,
    VK_FORMAT_R8G8_UNORM,
    VK_FORMAT_R8G8B8A8_UNORM,
    VK_FORMAT_R8G8B8A8_SRGB,
    VK_FORMAT_R8G8B8A8_SNORM,
    VK_FORMAT_R16_UNORM,
    VK_FORMAT_R16G16_UNORM,
    VK_FORMAT_R16G16B16A16_UNORM,
    VK_FORMAT_R16G16_SNORM,
    VK_FORMAT_R16G16B16A16_SNORM,
    VK_FORMAT_R16_SFLOAT,
    VK_FORMAT_R16G16_SFLOAT,
    VK_FORMAT_R16G16B16A16_SFLOAT,
    VK_FORMAT_R16_UINT,
    VK_FORMAT_R32_UINT,
    VK_FORMAT_R32G32_UINT,
    VK_FORMAT_R32G32B32A32_UINT,
    VK_FORMAT_R32_SFLOAT,
    VK_FORMAT_R32G32_SFLOAT,
    VK_FORMAT_R32G32B32A32_SFLOAT,
    VK_FORMAT_D32_SFLOAT,
};

class TransferTest : public GpuTest {
protected:
    static gpu::Image create(VkFormat format, uint32_t width, uint32_t height, uint32_t mips = 1, uint32_t layers = 1,
                             gpu::ImageShape shape = gpu::ImageShape::Flat) {
        return must(gpu::Image::create(
            gpu(), {"test/transfer", format, width, height, mips, layers, shape,
                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    }
    static std::span<const std::byte> bytes(const std::vector<float>& values) {
        return std::as_bytes(std::span(values));
    }
};

TEST_F(TransferTest, everyFormatComesBackByteForByte) {
    std::mt19937 random(5);
    for (const VkFormat format : kFormats) {
        const bool depth = format == VK_FORMAT_D32_SFLOAT;
        if (!gpu().supportsFormat(format, VK_FORMAT_FEATURE_2_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_2_TRANSFER_DST_BIT))
            continue;
        std::vector<std::byte> content(gpu::bytesPerTexel(format) * 13 * 7);
        ASSERT_FALSE(content.empty());
        for (std::byte& byte : content)
            byte = static_cast<std::byte>(random());
        if (depth) // depth images hold [0, 1]
            for (size_t i = 0; i + 4 <= content.size(); i += 4) {
                const float value = static_cast<float>(random() % 1000) / 1000;
                std::memcpy(content.data() + i, &value, 4);
            }
        gpu::Image image = create(format, 13, 7);
        must(gpu::uploadImage(gpu(), image, content));
        EXPECT_EQ(must(gpu::downloadImage(gpu(), image)), content) << "format " << format;
        EXPECT_EQ(must(gpu::downloadImageAsFloats(gpu(), image)).size(), 13u * 7 * 4);
    }
}

TEST_F(TransferTest, channelsBecomeTheNumbersTheyStandFor) {
    const auto first = [](VkFormat format, std::vector<uint8_t> content) {
        gpu::Image image = create(format, 1, 1);
        must(gpu::uploadImage(gpu(), image, std::as_bytes(std::span(content))));
        return must(gpu::downloadImageAsFloats(gpu(), image));
    };
    EXPECT_EQ(first(VK_FORMAT_R8_UNORM, {255}), (std::vector<float>{1, 0, 0, 1})) << "missing channels: 0, alpha 1";
    EXPECT_EQ(first(VK_FORMAT_R8G8B8A8_UNORM, {0, 51, 102, 255}),
              (std::vector<float>{0, 51 / 255.0f, 102 / 255.0f, 1}));
    EXPECT_EQ(first(VK_FORMAT_R8G8B8A8_SNORM, {0x80, 0x81, 0x7f, 0}), (std::vector<float>{-1, -1, 1, 0}));
    EXPECT_EQ(first(VK_FORMAT_R16G16_SNORM, {0x00, 0x80, 0xff, 0x7f}), (std::vector<float>{-1, 1, 0, 1}));
    EXPECT_EQ(first(VK_FORMAT_R16G16_SFLOAT, {0x00, 0x3c, 0x00, 0xc0}), (std::vector<float>{1, -2, 0, 1}));
    EXPECT_EQ(first(VK_FORMAT_R16_UINT, {0x01, 0x02}), (std::vector<float>{513, 0, 0, 1}));
    EXPECT_EQ(first(VK_FORMAT_R32_UINT, {7, 0, 1, 0}), (std::vector<float>{65543, 0, 0, 1}));
}

TEST_F(TransferTest, layersStayApart) {
    for (const gpu::ImageShape shape : {gpu::ImageShape::Array, gpu::ImageShape::Cube}) {
        std::vector<float> content;
        for (int layer = 0; layer < 6; ++layer)
            for (int texel = 0; texel < 4 * 4; ++texel)
                content.push_back(static_cast<float>(layer * 100 + texel));
        gpu::Image image = create(VK_FORMAT_R32_SFLOAT, 4, 4, 1, 6, shape);
        must(gpu::uploadImage(gpu(), image, bytes(content)));
        for (uint32_t layer = 0; layer < 6; ++layer) {
            const std::vector<float> values = must(gpu::downloadImageAsFloats(gpu(), image, 0, layer));
            for (uint32_t texel = 0; texel < 16; ++texel)
                ASSERT_EQ(values[texel * 4], static_cast<float>(layer * 100 + texel));
        }
    }
}

TEST_F(TransferTest, mipsAreTheMeanOfTheFourTexelsAbove) {
    constexpr uint32_t kSize = 16;
    constexpr uint32_t kLayers = 2;
    constexpr uint32_t kMips = 5;
    std::mt19937 random(9);
    std::vector<std::vector<std::vector<float>>> expected(kMips, std::vector<std::vector<float>>(kLayers));
    std::vector<float> content;
    for (uint32_t layer = 0; layer < kLayers; ++layer) {
        for (uint32_t i = 0; i < kSize * kSize * 4; ++i)
            expected[0][layer].push_back(static_cast<float>(random() % 256));
        content.insert(content.end(), expected[0][layer].begin(), expected[0][layer].end());
        for (uint32_t mip = 1; mip < kMips; ++mip) {
            const uint32_t size = kSize >> mip;
            const std::vector<float>& above = expected[mip - 1][layer];
            for (uint32_t y = 0; y < size; ++y)
                for (uint32_t x = 0; x < size; ++x)
                    for (uint32_t c = 0; c < 4; ++c) {
                        const auto at = [&](uint32_t dx, uint32_t dy) {
                            return above[((2 * y + dy) * size * 2 + 2 * x + dx) * 4 + c];
                        };
                        expected[mip][layer].push_back((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4);
                    }
        }
    }
    gpu::Image image = create(VK_FORMAT_R32G32B32A32_SFLOAT, kSize, kSize, kMips, kLayers, gpu::ImageShape::Array);
    must(gpu::uploadImage(gpu(), image, bytes(content)));
    for (uint32_t mip = 0; mip < kMips; ++mip)
        for (uint32_t layer = 0; layer < kLayers; ++layer) {
            const std::vector<float> values = must(gpu::downloadImageAsFloats(gpu(), image, mip, layer));
            ASSERT_EQ(values.size(), expected[mip][layer].size());
            for (size_t i = 0; i < values.size(); ++i)
                ASSERT_NEAR(values[i], expected[mip][layer][i], 1e-3) << "mip " << mip << " layer " << layer;
        }
}

TEST_F(TransferTest, oddSizesHaveAllTheirMips) {
    gpu::Image image = create(VK_FORMAT_R8G8B8A8_UNORM, 7, 5, 3);
    must(gpu::uploadImage(gpu(), image, std::vector<std::byte>(7 * 5 * 4, std::byte{200})));
    EXPECT_EQ(must(gpu::downloadImage(gpu(), image, 1)), std::vector<std::byte>(3 * 2 * 4, std::byte{200}));
    EXPECT_EQ(must(gpu::downloadImage(gpu(), image, 2)), std::vector<std::byte>(1 * 1 * 4, std::byte{200}));
}

TEST_F(TransferTest, buffersRoundTripAndEmptyOnesExist) {
    const std::vector<uint32_t> content = {1, 2, 3, 4, 5, 6, 7};
    gpu::Buffer buffer = must(gpu::uploadBuffer(gpu(), "test/buffer", content, VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
    const std::vector<std::byte> back = must(gpu::downloadBuffer(gpu(), buffer));
    ASSERT_EQ(back.size(), content.size() * 4);
    EXPECT_EQ(std::memcmp(back.data(), content.data(), back.size()), 0);
    gpu::Buffer empty =
        must(gpu::uploadBuffer(gpu(), "test/empty", std::vector<uint32_t>{}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    EXPECT_GT(empty.size(), 0u);
}

TEST_F(TransferTest, wrongSizesAndFormatsAreRefused) {
    gpu::Image image = create(VK_FORMAT_R8G8B8A8_UNORM, 4, 4);
    const Result<void> shortContent = gpu::uploadImage(gpu(), image, std::vector<std::byte>(63));
    ASSERT_FALSE(shortContent);
    EXPECT_THAT(shortContent.error().message, HasSubstr("takes 64 bytes, 63 were given"));
    EXPECT_EQ(gpu::bytesPerTexel(VK_FORMAT_BC7_UNORM_BLOCK), 0u);
}

} // namespace transfer_test
} // namespace glint::test
