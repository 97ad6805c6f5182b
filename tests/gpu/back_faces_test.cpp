// The host's back-face depth on its way into the library.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/frame.hpp"
#include "shared/frame_constants.h"

namespace glint::test {
namespace {

constexpr uint32_t kWidth = 32;
constexpr uint32_t kHeight = 18;

class BackFacesTest : public LibraryTest {
protected:
    static gpu::Image backDepth(const SyntheticCamera& camera, uint32_t width, uint32_t height) {
        std::vector<float> depth;
        for (uint32_t i = 0; i < width * height; ++i)
            depth.push_back(i % 3 == 0 ? 0.0f : static_cast<float>(camera.deviceDepth(2 + i * 0.01)));
        return uploadTestImage(gpu(), "test/backDepth", VK_FORMAT_R32_SFLOAT, width, height, bytesOf(depth));
    }
    static Settings backfaceSettings() {
        Settings settings = plainSettings();
        settings.screen.thicknessMode = ThicknessMode::Backface;
        return settings;
    }
};

TEST_F(BackFacesTest, BecomeMetresInTheirOwnSize) {
    for (const bool orthographic : {false, true}) {
        SyntheticCamera camera;
        camera.orthoHeight = orthographic ? 3 : 0;
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
        const gpu::Image back = backDepth(camera, 11, 6);
        const auto borrowed = [](const gpu::Image& image) {
            return gpu::Image::borrow(image.handle(), image.view(), image.desc(),
                                      {0, 0, 0, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
        };
        const auto frame =
            must(reflect::FrameState::create(library().gpu(), {kWidth, kHeight, backfaceSettings(), false, false}));
        frame->inputs = {borrowed(host.depth),
                         borrowed(host.normal),
                         borrowed(host.material),
                         borrowed(host.litRadiance),
                         {},
                         borrowed(back),
                         {}};
        must(frame->expectBackFaces(11, 6));
        run([&](VkCommandBuffer commands) {
            gpu::Frame recording(library().gpu(), commands);
            frame->record(recording, camera.view(kWidth, kHeight));
        });
        const std::vector<float> metres = must(gpu::downloadImageAsFloats(gpu(), frame->prepared.backViewZ));
        ASSERT_EQ(metres.size(), 11u * 6 * 4);
        for (uint32_t i = 0; i < 11 * 6; ++i)
            if (i % 3 == 0)
                ASSERT_EQ(metres[i * 4], shared::kBackgroundZ);
            else
                ASSERT_NEAR(metres[i * 4], 2 + i * 0.01, 2e-4);
    }
}

TEST_F(BackFacesTest, MayHaveAnySizeAndComeAndGo) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, backfaceSettings());
    GBuffer gbuffer = host.gbuffer;
    must(made.setInputs(gbuffer));
    const auto missing = [&] {
        return std::any_of(made.notes().begin(), made.notes().end(),
                           [](const std::string& note) { return note.starts_with("no backDepth"); });
    };
    EXPECT_TRUE(missing());
    trace(made, camera.view(kWidth, kHeight));
    for (const glm::uvec2 size : {glm::uvec2(kWidth, kHeight), glm::uvec2(1, 1), glm::uvec2(50, 3)}) {
        const gpu::Image back = backDepth(camera, size.x, size.y);
        gbuffer.backDepth = asHostImage(back);
        must(made.setInputs(gbuffer));
        EXPECT_FALSE(missing());
        trace(made, camera.view(kWidth, kHeight));
        must(made.setSettings(plainSettings()));
        trace(made, camera.view(kWidth, kHeight));
        must(made.setSettings(backfaceSettings()));
        trace(made, camera.view(kWidth, kHeight));
    }
    gbuffer.backDepth.width = 0;
    const Result<void> empty = made.setInputs(gbuffer);
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().message.find("backDepth"), std::string::npos);
    gbuffer.backDepth = {};
    must(made.setInputs(gbuffer));
    EXPECT_TRUE(missing());
    trace(made, camera.view(kWidth, kHeight));
    must(made.setSettings(plainSettings()));
    EXPECT_FALSE(missing());
}

} // namespace
} // namespace glint::test
