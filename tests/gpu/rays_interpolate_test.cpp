// rays.interpolate: where the rays around a pixel agree, it takes their mean; elsewhere it sends its own.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

namespace glint::test {
namespace rays_interpolate_test {

constexpr uint32_t kWidth = 65; // odd: the last column has neighbours on one side alone
constexpr uint32_t kHeight = 35;

class RaysInterpolateTest : public LibraryTest, public testing::WithParamInterface<RayBackend> {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        if (GetParam() == RayBackend::Query && !gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
    }

    /// Behind the camera: orange on one side, blue on the other.
    static SurfaceScene twoColours() {
        SurfaceScene scene;
        scene.addQuad({-20, -20, -4}, {40, 0, 0}, {0, 40, 0}, whiteMetal(0));
        scene.addQuad({0.3f, -80, 6}, {-160, 0, 0}, {0, 160, 0}, emitting({0.8f, 0.4f, 0.1f}));
        scene.addQuad({160.3f, -80, 6}, {-160, 0, 0}, {0, 160, 0}, emitting({0.1f, 0.2f, 0.9f}));
        return scene;
    }

    static Settings raySettings(float interpolate) {
        Settings settings;
        settings.screen.enabled = false;
        settings.denoise.enabled = false;
        settings.rays.enabled = true;
        settings.rays.interpolate = interpolate;
        settings.rays.environmentOcclusion = false; // where a path ends is not shown by where it first hits
        return settings;
    }

    static Picture look(const SurfaceScene& scene, const Settings& settings) {
        const SyntheticCamera camera = {.position = {0, 0, 3}, .target = {0, 0, 0}};
        SurfaceScene::World world = scene.build(gpu(), library(), GetParam());
        SyntheticGBuffer g = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene), camera, kWidth, kHeight);
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(g.gbuffer));
        must(reflections.setRays(world.rays, world.surfaces));
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        return LibraryTest::trace(reflections, camera.view(kWidth, kHeight));
    }
    static double mostApart(const Picture& a, const Picture& b) {
        double most = 0;
        for (size_t i = 0; i < a.pixels() * 4; ++i)
            most = std::max(most, std::abs(double(a.reflection[i]) - double(b.reflection[i])));
        return most;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, RaysInterpolateTest, testing::Values(RayBackend::Query, RayBackend::Bvh),
                         [](const auto& backend) { return backend.param == RayBackend::Query ? "query" : "bvh"; });

TEST_P(RaysInterpolateTest, aThirdOfTheRaysGivesThePictureOfAll) {
    const SurfaceScene scene = twoColours();
    for (const bool sampleLights : {false, true}) {
        Settings settings = raySettings(0);
        settings.rays.sampleLights = sampleLights; // a pipeline of its own
        const Picture all = look(scene, settings);
        settings.rays.interpolate = 0.1f;
        const Picture few = look(scene, settings);
        EXPECT_LT(mostApart(all, few), 1e-3) << sampleLights;
        EXPECT_EQ(all.statistics.scene.pixels, all.pixels()) << sampleLights;
        EXPECT_GT(few.statistics.scene.pixels, all.pixels() / 4) << sampleLights;
        EXPECT_LT(few.statistics.scene.pixels, all.pixels() / 3) << sampleLights;
    }
}

TEST_P(RaysInterpolateTest, atOneAnOutlineIsMixed) {
    const SurfaceScene scene = twoColours();
    const Picture all = look(scene, raySettings(0));
    const Picture fewest = look(scene, raySettings(1));
    size_t other = 0;
    for (size_t i = 0; i < all.pixels(); ++i) {
        const float red = fewest.reflection[i * 4];
        EXPECT_GE(red, 0.1f - 1e-3f);
        EXPECT_LE(red, 0.8f + 1e-3f);
        other += std::abs(red - all.reflection[i * 4]) > 0.1f ? 1 : 0;
    }
    EXPECT_GT(other, kHeight / 4);
    EXPECT_LT(other, 2 * kHeight);
    EXPECT_LT(fewest.statistics.scene.pixels, look(scene, raySettings(0.1f)).statistics.scene.pixels);
}

/// A post as wide as a pixel, that mirrors another thing than the wall around it.
TEST_P(RaysInterpolateTest, whatNeighboursDoNotShowSendsItsOwnRays) {
    SurfaceScene scene;
    scene.addQuad({-20, -20, -4}, {40, 0, 0}, {0, 40, 0}, whiteMetal(0));
    scene.addQuad({80, -80, 6}, {-160, 0, 0}, {0, 160, 0}, emitting({0.8f, 0.4f, 0.1f}));
    scene.addQuad({-10, -20, -20}, {0, 0, 40}, {0, 40, 0}, emitting({0.1f, 0.2f, 0.9f}));
    for (float x = -1.6f; x < 1.6f; x += 0.23f) // some stand between the pixels that send rays
        scene.addQuad({x, -3, -1}, {0.035f, 0, 0.035f}, {0, 6, 0}, whiteMetal(0));
    const Picture all = look(scene, raySettings(0));
    const Picture few = look(scene, raySettings(0.1f));
    size_t blue = 0;
    for (size_t i = 0; i < all.pixels(); ++i)
        blue += all.reflection[i * 4 + 2] > 0.5f ? 1 : 0;
    EXPECT_GE(blue, 4 * kHeight);
    EXPECT_LT(mostApart(all, few), 1e-3);
    EXPECT_LT(few.statistics.scene.pixels, all.statistics.scene.pixels);
}

/// The denoiser and rays.accumulate average each pixel's own rays.
TEST_P(RaysInterpolateTest, meansOfRaysAreNotInterpolated) {
    const SurfaceScene scene = twoColours();
    for (const bool accumulate : {false, true}) {
        Settings settings = raySettings(0);
        settings.denoise.enabled = !accumulate;
        settings.rays.accumulate = accumulate;
        const Picture without = look(scene, settings);
        settings.rays.interpolate = 0.5f;
        const Picture with = look(scene, settings);
        EXPECT_EQ(with.reflection, without.reflection) << accumulate;
        EXPECT_EQ(with.statistics.scene.pixels, without.statistics.scene.pixels) << accumulate;
    }
}

} // namespace rays_interpolate_test
} // namespace glint::test
