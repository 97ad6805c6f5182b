// Mips made by compute shaders are those of a linear blit, by Vulkan's formula. A device's own blit may weigh texels in
// steps of 1/256, which an NVIDIA H200 does.
#include "gpu/mip_chain.hpp"
#include "gpu/support/gpu_test.hpp"

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>

namespace glint::test {
namespace mip_chain_test {

class MipChainTest : public GpuTest {
protected:
    static gpu::Image image(uint32_t width, uint32_t height, uint32_t layers) {
        const auto mips = static_cast<uint32_t>(std::bit_width(std::max(width, height)));
        return must(gpu::Image::create(gpu(), {"test/mips", VK_FORMAT_R16G16B16A16_SFLOAT, width, height, mips, layers,
                                               layers > 1 ? gpu::ImageShape::Cube : gpu::ImageShape::Flat,
                                               VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                                   VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    }
    static std::vector<uint16_t> read(gpu::Image& image, uint32_t mip, uint32_t layer) {
        const size_t texels = size_t{std::max(image.width() >> mip, 1u)} * std::max(image.height() >> mip, 1u);
        gpu::Buffer buffer = must(gpu::Buffer::create(
            gpu(), {"test/read", texels * 8, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.copyToBuffer(image, mip, layer, buffer);
        });
        std::vector<uint16_t> halves(texels * 4);
        std::memcpy(halves.data(), buffer.mapped(), texels * 8);
        return halves;
    }
};

/// What a linear blit makes of a level of `width` x `height` texels, in double precision (Vulkan 1.3, 20.5 and 16.9).
std::vector<double> halved(const std::vector<uint16_t>& finer, int width, int height) {
    const int toWidth = std::max(width / 2, 1);
    const int toHeight = std::max(height / 2, 1);
    std::vector<double> coarser;
    for (int y = 0; y < toHeight; ++y)
        for (int x = 0; x < toWidth; ++x) {
            const double u = (x + 0.5) * width / toWidth - 0.5;
            const double v = (y + 0.5) * height / toHeight - 0.5;
            for (int channel = 0; channel < 4; ++channel) {
                const auto texel = [&](double atX, double atY) {
                    const int column = std::clamp(static_cast<int>(atX), 0, width - 1);
                    const int row = std::clamp(static_cast<int>(atY), 0, height - 1);
                    return static_cast<double>(
                        glm::unpackHalf1x16(finer[static_cast<size_t>((row * width + column) * 4 + channel)]));
                };
                const double x0 = std::floor(u);
                const double y0 = std::floor(v);
                coarser.push_back(std::lerp(std::lerp(texel(x0, y0), texel(x0 + 1, y0), u - x0),
                                            std::lerp(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), u - x0), v - y0));
            }
        }
    return coarser;
}

TEST_F(MipChainTest, levelsAreThoseOfALinearBlit) {
    for (const auto& [width, height, layers] :
         {std::array{64u, 64u, 6u}, {64u, 32u, 1u}, {37u, 21u, 1u}, {5u, 1u, 1u}}) {
        gpu::Image made = image(width, height, layers);
        const gpu::MipChain chain = must(gpu::MipChain::create(gpu(), layers));
        const size_t texels = size_t{width} * height;
        gpu::Buffer staging = must(gpu::Buffer::create(
            gpu(), {"test/staging", texels * 8, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::BufferHome::Upload}));
        for (uint32_t layer = 0; layer < layers; ++layer) {
            std::vector<uint16_t> content(texels * 4);
            for (size_t i = 0; i < content.size(); ++i) // bright and dark side by side, from 0 to 1000
                content[i] = glm::packHalf1x16(static_cast<float>((i * 7919 + layer * 31) % 1000) *
                                               (i % 13 == 0 ? 1.0f : 0.001f));
            std::memcpy(staging.mapped(), content.data(), texels * 8);
            run([&](VkCommandBuffer commands) {
                gpu::Frame frame(gpu(), commands);
                frame.copyFromBuffer(staging, 0, made, 0, layer);
            });
        }
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            chain.make(frame, made);
        });
        for (uint32_t layer = 0; layer < layers; ++layer) {
            std::vector<uint16_t> finer = read(made, 0, layer);
            for (uint32_t mip = 1; mip < made.desc().mips; ++mip) {
                const std::vector<double> expected = halved(finer, static_cast<int>(std::max(width >> (mip - 1), 1u)),
                                                            static_cast<int>(std::max(height >> (mip - 1), 1u)));
                const std::vector<uint16_t> got = read(made, mip, layer);
                ASSERT_EQ(got.size(), expected.size());
                double most = 0;
                for (size_t i = 0; i < got.size(); ++i) // a half's last bit, which stores may round either way
                    most = std::max(most, std::abs(static_cast<double>(glm::unpackHalf1x16(got[i])) - expected[i]) /
                                              std::max(std::abs(expected[i]), 1e-4));
                EXPECT_LE(most, 1.0 / 1024) << width << "x" << height << ", level " << mip << ", layer " << layer;
                finer = got;
            }
        }
    }
}

} // namespace mip_chain_test
} // namespace glint::test
