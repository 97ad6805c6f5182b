// Depths in a host's G-buffer that no surface has: every march ends, and no pixel of the picture is broken.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <cmath>
#include <limits>

namespace glint::test {
namespace broken_gbuffer_test {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 40;

class BrokenGBufferTest : public LibraryTest {};

TEST_F(BrokenGBufferTest, EveryMarchEndsWhateverTheDepth) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
    std::vector<float> depths(size_t{kWidth} * kHeight, 1000);
    const auto surfaces = seen(floorAndWall(), camera, kWidth, kHeight);
    for (uint32_t i = 0; i < depths.size(); ++i)
        if (surfaces[i]) {
            const glm::dvec3 ray = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            depths[i] = static_cast<float>(camera.viewZ(camera.position + ray * surfaces[i]->distance));
        }
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const float broken[] = {1e-25f, 1e-38f, 1e-10f, -1, kInfinite, std::nanf(""), 1e30f, 0};
    uint32_t next = 0;
    for (uint32_t i = kWidth * (kHeight - 4) + 3; i < depths.size(); i += 7) // of the floor, close to the eye
        depths[i] = broken[next++ % std::size(broken)];
    const gpu::Image image =
        uploadTestImage(gpu(), "test/broken", VK_FORMAT_R32_SFLOAT, kWidth, kHeight, bytesOf(depths));
    GBuffer gbuffer = host.gbuffer;
    gbuffer.depth = asHostImage(image);
    gbuffer.conventions.depth = DepthKind::LinearViewZ;
    for (const March march : {March::Hiz, March::Linear, March::Adaptive})
        for (const int minLevel : {0, 2}) {
            Settings settings = plainSettings(march);
            settings.hiz.minLevel = minLevel;
            Reflections made = reflections(kWidth, kHeight, settings);
            must(made.setInputs(gbuffer));
            const Picture picture = trace(made, camera.view(kWidth, kHeight));
            EXPECT_GT(picture.counted("hit"), 300u);
            for (const float value : picture.composite)
                ASSERT_TRUE(std::isfinite(value));
        }
}

} // namespace broken_gbuffer_test
} // namespace glint::test
