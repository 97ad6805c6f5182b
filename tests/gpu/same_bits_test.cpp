// The same frame gives the same bits, however a driver schedules it. Random differences appear only rarely, so the test
// runs many rounds, each with its own Reflections.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include "reflect/trace/technique.hpp"

namespace glint::test {
namespace same_bits_test {

constexpr uint32_t kWidth = 96;
constexpr uint32_t kHeight = 64;
constexpr int kRounds = 20;

class SameBitsTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        // Small, so that rays meet its corners often, and of one colour that half floats hold: where they are stored
        // rounding down, the last bit of a lookup shows.
        environment_ =
            TestEnvironment::make(gpu(), 4, 1, [](const auto&, uint32_t) { return glm::vec3(0.1, 0.3, 0.7); });
    }

    /// `make`: a fresh Reflections, ready for its first frame.
    template <class Make>
    void expectSameBits(const SyntheticCamera& camera, Make make) {
        View view = camera.view(kWidth, kHeight);
        view.frameIndex = 3;
        view.seed = 5;
        Reflections kept = make(); // so that pipelines are built once
        const Picture first = trace(kept, view);
        for (int round = 1; round < kRounds; ++round) {
            Reflections reflections = make();
            const Picture picture = trace(reflections, view);
            ASSERT_EQ(picture.composite, first.composite) << "round " << round;
            ASSERT_EQ(picture.reflection, first.reflection) << "round " << round;
            ASSERT_EQ(picture.hitUV, first.hitUV) << "round " << round;
            ASSERT_EQ(picture.hitDistance, first.hitDistance) << "round " << round;
        }
    }

    TestEnvironment environment_;
};

TEST_F(SameBitsTest, everyMarcherWithTheSky) {
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.3f;
    const SyntheticCamera camera;
    SyntheticGBuffer gbuffer = SyntheticGBuffer::render(gpu(), stage, camera, kWidth, kHeight);
    for (const reflect::Technique& technique : reflect::techniques()) {
        SCOPED_TRACE(technique.name);
        Settings settings = plainSettings(technique.march);
        settings.rough.factor = 0.5f;
        std::optional<TestVolumes> volumes;
        expectSameBits(camera, [&] {
            Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
            must(reflections.setInputs(gbuffer.gbuffer, environment_.map));
            volumes = TestVolumes::giveTo(reflections, gpu(), library(), {wallVolume()});
            return reflections;
        });
    }
}

TEST_F(SameBitsTest, raysThroughTheScene) {
    SurfaceScene scene;
    scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.5f));
    const SyntheticCamera camera = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    SyntheticGBuffer gbuffer = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene), camera, kWidth, kHeight);
    SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
    run([&](VkCommandBuffer commands) {
        world.rays.record(commands);
        world.surfaces.record(commands);
    });
    Settings settings;
    settings.screen.enabled = false;
    settings.rays.enabled = true;
    expectSameBits(camera, [&] {
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(gbuffer.gbuffer, environment_.map));
        must(reflections.setRays(world.rays, world.surfaces));
        return reflections;
    });
}

} // namespace same_bits_test
} // namespace glint::test
