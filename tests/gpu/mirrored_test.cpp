// What mirrors show of rough surfaces, with denoise.enabled and rays.bounces above 1: the mean over frames of what the
// further rays find, looked for where the mirror, flat or curved, showed the surface before.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>

namespace glint::test {
namespace mirrored_test {

constexpr uint32_t kWidth = 64;
constexpr uint32_t kHeight = 64;
constexpr uint32_t kFrames = 24;
constexpr double kStep = 0.03; ///< metres a frame: about a pixel

/// Behind the camera a metal wall of this roughness, and stripes of light far behind the mirror, which it reflects.
SurfaceScene wallBefore(float perceptualRoughness) {
    SurfaceScene made;
    made.addQuad({20, -20, 5}, {-40, 0, 0}, {0, 40, 0}, whiteMetal(perceptualRoughness));
    for (int i = -6; i < 6; ++i)
        made.addQuad({static_cast<float>(3 * i), -20, -6}, {3, 0, 0}, {0, 40, 0},
                     emitting(glm::vec3(i % 2 == 0 ? 1.0f : 0.1f)));
    return made;
}

class MirroredTest : public LibraryTest {
protected:
    static Settings settings(bool denoises) {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.bounces = 2;
        settings.denoise.enabled = denoises;
        return settings;
    }

    struct Shown {
        Picture picture;
        double frames = 0; ///< in the mean, over the picture's middle
    };

    /// `count` frames of a camera that moves by `step` metres a frame and ends at x = 0.
    static Shown play(const SyntheticScene& mirror, const SurfaceScene& scene, const Settings& settings, uint32_t count,
                      double step, uint32_t seed) {
        SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setRays(world.rays, world.surfaces));
        Shown shown;
        for (uint32_t i = 0; i < count; ++i) {
            const double x = -step * (count - 1 - i);
            const SyntheticCamera camera = {.position = {x, 0, 3.5}, .target = {x, 0, 0}, .fovY = 0.55};
            const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), mirror, camera, kWidth, kHeight);
            must(made.setInputs(host.gbuffer));
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = i;
            view.seed = seed;
            shown.picture = trace(made, view);
            if (settings.denoise.enabled && i + 1 == count) {
                const std::vector<float> counts = readView(made, "historyFrames");
                overMiddle([&](size_t pixel) { shown.frames += double(counts[4 * pixel]) / kMiddle; });
            }
        }
        return shown;
    }

    static constexpr double kMiddle = kWidth * kHeight / 4.0; ///< pixels
    template <class Function>
    static void overMiddle(const Function& function) {
        for (size_t y = kHeight / 4; y < kHeight * 3 / 4; ++y)
            for (size_t x = kWidth / 4; x < kWidth * 3 / 4; ++x)
                function(y * kWidth + x);
    }
    static double meanOf(const Picture& a) {
        double sum = 0;
        overMiddle([&](size_t pixel) { sum += double(a.reflection[4 * pixel]); });
        return sum / kMiddle;
    }
    /// Root of the mean squared difference.
    static double difference(const Picture& a, const Picture& b) {
        double sum = 0;
        overMiddle(
            [&](size_t pixel) { sum += std::pow(double(a.reflection[4 * pixel] - b.reflection[4 * pixel]), 2); });
        return std::sqrt(sum / kMiddle);
    }
    static Picture truth(const SyntheticScene& mirror, const SurfaceScene& scene) {
        Settings converging = settings(false);
        converging.rays.samples = 64;
        converging.rays.accumulate = true;
        return play(mirror, scene, converging, 8, 0, 7).picture;
    }
};

TEST_F(MirroredTest, atRestTheNoiseOfTheSecondBounceFalls) {
    const SurfaceScene scene = wallBefore(0.3f);
    for (const SyntheticScene& mirror : {SyntheticScene(flatMirror), unitBall(0)}) {
        const Picture right = truth(mirror, scene);
        const double raw = difference(play(mirror, scene, settings(false), 1, 0, 1).picture, right);
        const Picture shown = play(mirror, scene, settings(true), kFrames, 0, 1).picture;
        std::cout << "error of one frame " << raw << ", of the mean " << difference(shown, right) << "; mean radiance "
                  << meanOf(shown) << " of " << meanOf(right) << "\n";
        EXPECT_LT(difference(shown, right), raw / 6);
        // The ball's picture of the wall ends near the middle's border, and is smoothed across it.
        EXPECT_NEAR(meanOf(shown), meanOf(right), 0.05 * meanOf(right));
    }
}

TEST_F(MirroredTest, aFirstFrameUsesTheRaysOfNeighbours) {
    const SurfaceScene scene = wallBefore(0.5f);
    const Picture right = truth(flatMirror, scene);
    const double raw = difference(play(flatMirror, scene, settings(false), 1, 0, 1).picture, right);
    EXPECT_LT(difference(play(flatMirror, scene, settings(true), 1, 0, 1).picture, right), raw / 3);
}

TEST_F(MirroredTest, inMotionTheMeanIsFoundWhereTheMirrorShowedIt) {
    const SurfaceScene scene = wallBefore(0.4f);
    for (const SyntheticScene& mirror : {SyntheticScene(flatMirror), unitBall(0)}) {
        const Picture right = truth(mirror, scene);
        const double raw = difference(play(mirror, scene, settings(false), 1, 0, 1).picture, right);
        const Shown rested = play(mirror, scene, settings(true), kFrames, 0, 1);
        const Shown moved = play(mirror, scene, settings(true), kFrames, kStep, 1);
        std::cout << "frames kept: " << moved.frames << " of " << rested.frames << "; error " << raw << ", at rest "
                  << difference(rested.picture, right) << ", in motion " << difference(moved.picture, right) << "\n";
        EXPECT_GT(moved.frames, 0.5 * rested.frames);
        EXPECT_LT(difference(moved.picture, right), raw / 5);
    }
}

TEST_F(MirroredTest, mirrorsThatShowNoRoughSurfaceKeepTheirBits) {
    SurfaceScene scene = wallBefore(0); // a mirror that shows a mirror that shows light
    scene.addQuad({20, -20, 4}, {-20, 0, 0}, {0, 40, 0}, emitting({0.5f, 0.25f, 2}));
    const Picture raw = play(unitBall(0), scene, settings(false), 3, kStep, 1).picture;
    const Picture shown = play(unitBall(0), scene, settings(true), 3, kStep, 1).picture;
    EXPECT_EQ(raw.reflection, shown.reflection);
    EXPECT_EQ(raw.weight, shown.weight);
}

} // namespace mirrored_test
} // namespace glint::test
