// Where the denoiser looks for a pixel's history: against places known by hand, and steady from frame to frame.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace reprojection_test {

/// A smooth floor before a wall whose brightness changes along x.
class ReprojectionTest : public LibraryTest {
protected:
    static constexpr uint32_t kWidth = 96;
    static constexpr uint32_t kHeight = 64;
    static constexpr double kWallZ = -3;

    static SyntheticScene floorBeforeWall(float perceptualRoughness) {
        Stage stage = floorAndWall();
        stage.floorRoughness = perceptualRoughness;
        return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
            auto hit = stage(origin, direction);
            if (hit && hit->f0.x == 0)
                hit->radiance = glm::vec3(1.5f + std::sin(hit->radiance.x));
            return hit;
        };
    }

    static Settings settings() {
        Settings settings = plainSettings();
        settings.denoise.enabled = true;
        settings.denoise.stabilizeSeconds = 0.5f; // keeps the image of places
        settings.reuse.rate = RayRate::Full;
        settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
        return settings;
    }

    /// Pixels of the previous frame relative to the pixel, x and y of four floats, after each frame.
    static std::vector<std::vector<float>> placesTaken(const SyntheticScene& scene,
                                                       const std::vector<SyntheticCamera>& cameras) {
        Reflections made = reflections(kWidth, kHeight, settings());
        std::vector<std::vector<float>> places;
        for (uint32_t i = 0; i < cameras.size(); ++i) {
            const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, cameras[i], kWidth, kHeight);
            must(made.setInputs(host.gbuffer));
            View view = cameras[i].view(kWidth, kHeight);
            view.frameIndex = i;
            trace(made, view);
            places.push_back(readView(made, "denoise/accumulate:takenFrom"));
        }
        return places;
    }

    /// Where the previous camera saw, mirrored in the floor, what a pixel mirrors. Empty: not the floor, or not the
    /// wall.
    static std::optional<glm::dvec2> trueWay(const SyntheticCamera& before, const SyntheticCamera& now, uint32_t x,
                                             uint32_t y) {
        const glm::dvec3 ray = now.rayThrough(x, y, kWidth, kHeight);
        if (ray.y >= 0)
            return std::nullopt;
        const glm::dvec3 floor = now.position - ray * (now.position.y / ray.y);
        if (floor.z < kWallZ)
            return std::nullopt;
        const glm::dvec3 mirrored = {ray.x, -ray.y, ray.z};
        const glm::dvec3 wall = floor + mirrored * ((kWallZ - floor.z) / mirrored.z);
        const glm::dvec2 was = before.project({wall.x, -wall.y, wall.z}, kWidth, kHeight);
        return was - (glm::dvec2(x, y) + 0.5);
    }
};

TEST_F(ReprojectionTest, AFlatMirrorsPictureIsFoundWhereItWas) {
    struct Movement {
        const char* name;
        glm::dvec3 position, target; ///< of a frame
    };
    for (const Movement& moves : {Movement{"pan", {0, 0, 0}, {0.05, 0, 0}},
                                  {"truck", {0.08, 0, 0}, {0.08, 0, 0}},
                                  {"rise", {0, 0.04, 0}, {0, 0.04, 0}},
                                  {"dolly", {0, 0, -0.08}, {0, 0, -0.08}}}) {
        std::vector<SyntheticCamera> cameras(8);
        for (size_t i = 0; i < cameras.size(); ++i) {
            cameras[i].position += moves.position * static_cast<double>(i);
            cameras[i].target += moves.target * static_cast<double>(i);
        }
        const std::vector<float> places = placesTaken(floorBeforeWall(0.12f), cameras).back();
        std::vector<double> errors;
        double moved = 0;
        for (uint32_t y = 0; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const auto way = trueWay(cameras[6], cameras[7], x, y);
                const float* const found = &places[4 * (y * kWidth + x)];
                // Near the wall surface and picture move alike, and so do they at the picture's border, where one is
                // lost.
                const bool inside = x > 4 && y > 4 && x + 4 < kWidth && y + 4 < kHeight;
                if (!way || !inside || found[0] > 1e4f || (found[0] == 0 && found[1] == 0))
                    continue;
                errors.push_back(glm::distance(*way, glm::dvec2(found[0], found[1])));
                moved += glm::length(*way);
            }
        ASSERT_GT(errors.size(), 1000u) << moves.name;
        std::ranges::sort(errors);
        const double count = static_cast<double>(errors.size());
        std::cout << moves.name << ": " << moved / count << " px, off by " << errors[errors.size() / 2] << ", "
                  << errors[errors.size() * 95 / 100] << " (95 %)\n";
        EXPECT_LT(errors[errors.size() * 95 / 100], 0.1) << moves.name;
    }
}

TEST_F(ReprojectionTest, TheChoiceOfPlaceHoldsStill) {
    // A camera that trembles by parts of a pixel: neither place is better, and the choice must not strobe.
    std::vector<SyntheticCamera> cameras(12);
    for (size_t i = 0; i < cameras.size(); ++i) {
        const auto turn = static_cast<double>(i);
        cameras[i].target += glm::dvec3(0.008 * std::sin(2.4 * turn), 0.008 * std::cos(2.4 * turn), 0);
    }
    const auto places = placesTaken(floorBeforeWall(0.2f), cameras);
    size_t flips = 0, pixels = 0;
    for (size_t i = 6; i < places.size(); ++i)
        for (uint32_t y = 4; y + 4 < kHeight; ++y)
            for (uint32_t x = 4; x + 4 < kWidth; ++x) {
                const auto way = trueWay(cameras[i - 1], cameras[i], x, y);
                const float* const found = &places[i][4 * (y * kWidth + x)];
                if (!way || found[0] > 1e4f) // beside the wall nothing was there
                    continue;
                ++pixels;
                // The camera turns: surface and picture move alike, so that any other place is wrong.
                flips += glm::distance(*way, glm::dvec2(found[0], found[1])) > 0.25 ? 1 : 0;
            }
    ASSERT_GT(pixels, 6000u);
    EXPECT_LT(static_cast<double>(flips), 0.01 * static_cast<double>(pixels));
}

/// A rough metal ball before stripes of light that only rays meet, and a camera that moves past it.
class MovingPastABallTest : public LibraryTest {
protected:
    static constexpr uint32_t kWidth = 64;
    static constexpr uint32_t kHeight = 64;
    static constexpr uint32_t kFrames = 24;

    static SurfaceScene stripes() {
        SurfaceScene made;
        for (int i = -12; i < 12; ++i)
            made.addQuad({static_cast<float>(i + 1), -6, 5}, {-1, 0, 0}, {0, 12, 0},
                         emitting(glm::vec3(i % 2 == 0 ? 1.0f : 0.2f)));
        return made;
    }

    struct Kept {
        double frames; ///< in the mean, over the ball's middle
        Picture picture;
    };
    Kept moved(VirtualMotion motion, double step, uint32_t frames) {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.denoise.enabled = true;
        settings.denoise.antilag = Antilag::Off;
        settings.denoise.maxRadius = 0;
        settings.denoise.virtualMotion = motion;
        settings.reuse.rate = RayRate::Full;
        SurfaceScene::World world = stripes().build(gpu(), library(), RayBackend::Bvh);
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
        });
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setRays(world.rays, world.surfaces));
        Kept kept = {};
        for (uint32_t i = 0; i < frames; ++i) {
            const double x = -step * (frames - 1 - i);
            const SyntheticCamera camera = {.position = {x, 0, 3.5}, .target = {x, 0, 0}, .fovY = 0.55};
            const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), unitBall(0.25f), camera, kWidth, kHeight);
            must(made.setInputs(host.gbuffer));
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = i;
            kept.picture = trace(made, view);
            if (i + 1 == frames) {
                const std::vector<float> counts = readView(made, "historyFrames");
                size_t pixels = 0;
                for (uint32_t y = kHeight / 4; y < kHeight * 3 / 4; ++y)
                    for (uint32_t column = kWidth / 4; column < kWidth * 3 / 4; ++column, ++pixels)
                        kept.frames += counts[4 * (y * kWidth + column)];
                kept.frames /= static_cast<double>(pixels);
            }
        }
        return kept;
    }
};

TEST_F(MovingPastABallTest, ItsHistoryIsWhereACurvedMirrorShowsIt) {
    const auto error = [](const Picture& a, const Picture& b) {
        double sum = 0;
        for (uint32_t y = kHeight / 4; y < kHeight * 3 / 4; ++y)
            for (uint32_t x = kWidth / 4; x < kWidth * 3 / 4; ++x) {
                const double apart = a.reflection[4 * (y * kWidth + x)] - b.reflection[4 * (y * kWidth + x)];
                sum += apart * apart;
            }
        return std::sqrt(sum / (0.25 * kWidth * kHeight));
    };
    const Picture rested = moved(VirtualMotion::Curved, 0, 96).picture;
    constexpr double kStep = 0.03; // about a pixel
    const Kept surface = moved(VirtualMotion::Surface, kStep, kFrames);
    const Kept flat = moved(VirtualMotion::Flat, kStep, kFrames);
    const Kept curved = moved(VirtualMotion::Curved, kStep, kFrames);
    std::cout << "frames kept: surface " << surface.frames << ", flat " << flat.frames << ", curved " << curved.frames
              << "; error: " << error(surface.picture, rested) << ", " << error(flat.picture, rested) << ", "
              << error(curved.picture, rested) << "\n";
    EXPECT_GT(curved.frames, 1.5 * flat.frames);
    EXPECT_GE(flat.frames, surface.frames);
    EXPECT_LT(error(curved.picture, rested), error(flat.picture, rested));
}

} // namespace reprojection_test
} // namespace glint::test
