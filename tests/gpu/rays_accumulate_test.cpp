// The source `rays` over many frames: the mean of all samples, and when accumulation restarts.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>

namespace glint::test {
namespace rays_accumulate_test {

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 32;

/// A glossy floor under an environment that is bright on one side, with rays.accumulate.
class RaysAccumulateTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.5f));
        environment_ = TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3& direction, uint32_t) {
            return glm::vec3(direction.x > 0 ? 1 : 0.1, direction.z > 0 ? 1 : 0.1, 0.5);
        });
        world_.emplace(scene_.build(gpu(), library(), RayBackend::Bvh));
        gbuffer_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
        run([&](VkCommandBuffer commands) {
            world_->rays.record(commands);
            world_->surfaces.record(commands);
        });
    }

    static Settings raySettings(bool accumulate, int samples) {
        Settings settings;
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.accumulate = accumulate;
        settings.rays.samples = samples;
        settings.denoise.enabled = false;
        return settings;
    }

    Reflections start(bool accumulate, int samples = 1) {
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, raySettings(accumulate, samples));
        must(reflections.setInputs(gbuffer_.gbuffer, environment_.map));
        must(reflections.setRays(world_->rays, world_->surfaces));
        return reflections;
    }

    View view(uint32_t frame, uint32_t seed = 0) const {
        View view = camera_.view(kWidth, kHeight);
        view.frameIndex = frame;
        view.seed = seed;
        return view;
    }

    /// The last of `frames` frames.
    static Picture last(Reflections& reflections, uint32_t frames, const std::function<View(uint32_t)>& viewOf) {
        for (uint32_t i = 0; i + 1 < frames; ++i)
            run([&](VkCommandBuffer commands) { reflections.record(commands, viewOf(i)); });
        return trace(reflections, viewOf(frames - 1));
    }
    Picture last(Reflections& reflections, uint32_t frames, uint32_t seed = 0) const {
        return last(reflections, frames, [&](uint32_t i) { return view(i, seed); });
    }

    static double error(const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.composite.size(); ++i)
            sum += (double(a.composite[i]) - b.composite[i]) * (double(a.composite[i]) - b.composite[i]);
        return std::sqrt(sum / double(a.composite.size()));
    }

    SurfaceScene scene_;
    TestEnvironment environment_;
    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    SyntheticGBuffer gbuffer_;
    std::optional<SurfaceScene::World> world_;
};

TEST_F(RaysAccumulateTest, ErrorFallsWithTheRootOfTheSamples) {
    Reflections many = start(true, 256);
    const Picture truth = last(many, 16, 7);
    double before = 0;
    for (const uint32_t frames : {1u, 4u, 16u, 64u}) {
        Reflections reflections = start(true);
        const double now = error(last(reflections, frames), truth);
        if (frames > 1) {
            EXPECT_LT(now, before * 0.6) << frames; // a half by chance alone; the sequence is better
        }
        before = now;
    }
    EXPECT_LT(before, 0.01);
}

TEST_F(RaysAccumulateTest, FramesOrSamplesAreTheSame) {
    Reflections inFrames = start(true, 4);
    Reflections atOnce = start(true, 32);
    // The image stores half floats.
    EXPECT_LT(error(last(inFrames, 8), last(atOnce, 1)), 1e-3);
}

TEST_F(RaysAccumulateTest, StartsAnewWithTheViewTheSettingsAndWhenAsked) {
    Reflections fresh = start(true);
    const Picture alone = last(fresh, 1, [&](uint32_t) { return view(9); });

    Reflections moved = start(true);
    SyntheticCamera elsewhere = camera_;
    elsewhere.position.x += 0.5;
    last(moved, 4, [&](uint32_t) { return elsewhere.view(kWidth, kHeight); });
    EXPECT_EQ(last(moved, 1, [&](uint32_t) { return view(9); }).composite, alone.composite);

    Reflections asked = start(true);
    last(asked, 4);
    asked.restartAccumulation();
    EXPECT_EQ(last(asked, 1, [&](uint32_t) { return view(9); }).composite, alone.composite);

    Reflections changed = start(true);
    last(changed, 4);
    Settings settings = raySettings(true, 1);
    settings.sky.enabled = false;
    must(changed.setSettings(settings));
    last(changed, 2);
    settings.sky.enabled = true;
    must(changed.setSettings(settings));
    EXPECT_EQ(last(changed, 1, [&](uint32_t) { return view(9); }).composite, alone.composite);

    Reflections without = start(false);
    last(without, 4);
    const Picture single = last(without, 1, [&](uint32_t) { return view(9); });
    EXPECT_LT(error(single, alone), 0.02) << "one frame alone, but for samples below the surface";
    Reflections held = start(true);
    last(held, 4);
    EXPECT_GT(error(last(held, 1, [&](uint32_t) { return view(9); }), alone), 0.02) << "four frames more";
}

} // namespace rays_accumulate_test
} // namespace glint::test
