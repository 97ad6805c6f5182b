// Mips made by compute shaders equal those that a linear blit makes.
#include "gpu/mip_chain.hpp"
#include "gpu/support/gpu_test.hpp"

#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>

namespace glint::test {
namespace {

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

TEST_F(MipChainTest, levelsAreThoseOfALinearBlit) {
    for (const auto& [width, height, layers] :
         {std::array{64u, 64u, 6u}, {64u, 32u, 1u}, {37u, 21u, 1u}, {5u, 1u, 1u}}) {
        gpu::Image blitted = image(width, height, layers);
        gpu::Image dispatched = image(width, height, layers);
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
                frame.copyFromBuffer(staging, 0, blitted, 0, layer);
                frame.copyFromBuffer(staging, 0, dispatched, 0, layer);
            });
        }
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.makeMips(blitted);
            chain.make(frame, dispatched);
        });
        for (uint32_t mip = 1; mip < blitted.desc().mips; ++mip)
            for (uint32_t layer = 0; layer < layers; ++layer) {
                const std::vector<uint16_t> expected = read(blitted, mip, layer);
                const std::vector<uint16_t> got = read(dispatched, mip, layer);
                int most = 0; // positive halves: adjacent values are consecutive integers
                for (size_t i = 0; i < got.size(); ++i)
                    most = std::max(most, std::abs(static_cast<int>(got[i]) - static_cast<int>(expected[i])));
                EXPECT_LE(most, 1) // the last bit of a half, where the weights are not powers of two
                    << width << "x" << height << ", level " << mip << ", layer " << layer;
            }
    }
}

} // namespace
} // namespace glint::test
