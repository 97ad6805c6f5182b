// The list of rays (trace/ray_list.glsl, trace/list): every ray once, in the one order that the image gives.
#include "gpu/support/gpu_test.hpp"

#include "reflect/trace/ray_list.hpp"

#include <algorithm>
#include <cstring>

namespace glint::test {
namespace ray_list_test {

constexpr reflect::RayLister::IfAny kIfAny = {{3, 2}, {7, 5}};

class RayListTest : public GpuTest {
protected:
    struct Listed {
        shared::RayListHeader header;
        std::vector<uint32_t> pixels;
    };

    static Listed list(uint32_t width, uint32_t height, uint32_t percent, reflect::RayLister& lister,
                       reflect::Rays& rays) {
        struct {
            glm::uvec2 size;
            uint32_t percent;
        } const constants = {{width, height}, percent};
        const gpu::Pipeline needsRay = must(gpu::Pipeline::compute(gpu(), {"needs_ray", sizeof(constants), {}}));
        gpu::Buffer readback = must(gpu::Buffer::create(
            gpu(), {"test/readback", rays.list.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            lister.begin(frame);
            gpu::Pass pass = frame.pass(needsRay);
            lister.bind(pass).push(constants).dispatch(width, height);
            lister.list(frame, rays, width, height, kIfAny);
            frame.copyBuffer(rays.list, readback);
        });
        Listed listed;
        std::memcpy(&listed.header, readback.mapped(), sizeof(listed.header));
        const auto* pixels = static_cast<const std::byte*>(readback.mapped()) + sizeof(listed.header);
        listed.pixels.resize(listed.header.rayCount);
        std::memcpy(listed.pixels.data(), pixels, listed.pixels.size() * sizeof(uint32_t));
        return listed;
    }

    /// Tile by tile, row by row within a tile.
    static std::vector<uint32_t> expected(uint32_t width, uint32_t height, uint32_t percent) {
        std::vector<uint32_t> pixels;
        for (uint32_t tileY = 0; tileY < height; tileY += shared::kRayTileWidth)
            for (uint32_t tileX = 0; tileX < width; tileX += shared::kRayTileWidth)
                for (uint32_t i = 0; i < shared::kRayTilePixels; ++i) {
                    const uint32_t x = tileX + i % shared::kRayTileWidth;
                    const uint32_t y = tileY + i / shared::kRayTileWidth;
                    const uint32_t number = (x * 2654435761u) ^ (y * 2246822519u);
                    if (x < width && y < height && (number >> 8) % 100 < percent)
                        pixels.push_back(x | y << 16);
                }
        return pixels;
    }
};

TEST_F(RayListTest, isInTheOrderOfThePicture) {
    constexpr uint32_t kWidth = 1000;
    constexpr uint32_t kHeight = 300;
    reflect::RayLister lister = must(reflect::RayLister::create(gpu(), kWidth, kHeight));
    reflect::Rays rays = {must(gpu::Buffer::create(
        gpu(), {"test/rays", sizeof(shared::RayListHeader) + size_t{4} * kWidth * kHeight,
                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::BufferHome::Device}))};
    // Smaller images after a large one: rays left over from the large one are not listed.
    for (const auto& [width, height] : {std::pair{kWidth, kHeight}, {1u, 1u}, {17u, 9u}, {512u, 8u}, {520u, 8u}})
        for (const uint32_t percent : {0u, 3u, 50u, 100u}) {
            SCOPED_TRACE(testing::Message() << width << " x " << height << ", " << percent << " %");
            const Listed listed = list(width, height, percent, lister, rays);
            const std::vector<uint32_t> pixels = expected(width, height, percent);
            const bool any = !pixels.empty();
            EXPECT_EQ(listed.pixels, pixels);
            const auto count = static_cast<uint32_t>(pixels.size());
            EXPECT_EQ(listed.header.rayGroups[0], shared::kRayGroupsX);
            EXPECT_EQ(listed.header.rayGroups[1], (count + 4095) / 4096);
            EXPECT_EQ(listed.header.rayGroups[2], 1u);
            EXPECT_EQ(listed.header.pyramidGroups[0], any ? kIfAny.pyramidGroups.x : 0);
            EXPECT_EQ(listed.header.pyramidGroups[1], any ? kIfAny.pyramidGroups.y : 0);
            EXPECT_EQ(listed.header.pyramidGroups[2], 1u);
            EXPECT_EQ(listed.header.backFaceGroups[0], any ? kIfAny.backFaceGroups.x : 0);
            EXPECT_EQ(listed.header.backFaceGroups[1], any ? kIfAny.backFaceGroups.y : 0);
            EXPECT_EQ(listed.header.backFaceGroups[2], 1u);
            const bool rough = std::ranges::any_of(pixels, [](uint32_t px) { return (px & 0xffff) % 512 == 16; });
            EXPECT_EQ(listed.header.pictureGroups[0], rough ? kIfAny.pyramidGroups.x : 0);
            EXPECT_EQ(listed.header.pictureGroups[1], rough ? kIfAny.pyramidGroups.y : 0);
            EXPECT_EQ(listed.header.pictureGroups[2], 1u);
        }
}

} // namespace ray_list_test
} // namespace glint::test
