// rays.sampleLights: rays to emissive triangles and to the environment change the noise, not the mean.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>

namespace glint::test {
namespace rays_sample_lights_test {

constexpr uint32_t kWidth = 24;
constexpr uint32_t kHeight = 16;

/// A rough metal floor under whatever a test adds.
class RaysSampleLightsTest : public LibraryTest, public testing::WithParamInterface<RayBackend> {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        if (GetParam() == RayBackend::Query && !gpu().rayQuery())
            GTEST_SKIP() << "no ray queries on " << gpu().info().name;
        settings_.screen.enabled = false;
        settings_.rays.enabled = true;
        settings_.rays.accumulate = true;
        settings_.rays.bounces = 2;
        settings_.rays.regularization = 0;
    }

    void addFloor(float perceptualRoughness) {
        scene_.addQuad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, whiteMetal(perceptualRoughness));
    }
    /// A square over the floor, `side` metres long, that shines down.
    void addLamp(float side, const SurfaceMaterial& material) {
        scene_.addQuad({-0.5f * side, 2, -1 - 0.5f * side}, {side, 0, 0}, {0, 0, side}, material);
    }
    /// A sky that is dim but for a sun of `degrees` across.
    void addSun(double degrees, float radiance, const glm::dvec3& towards = {0.4, 0.8, -0.6}) {
        const glm::dvec3 sun = glm::normalize(towards);
        const double cosine = std::cos(degrees / 360 * 3.14159265);
        environment_ = TestEnvironment::make(gpu(), 128, 1, [=](const glm::dvec3& direction, uint32_t) {
            return glm::vec3(glm::dot(direction, sun) > cosine ? radiance : 0.1f + 0.1f * float(direction.y > 0));
        });
    }
    void build() {
        world_.emplace(scene_.build(gpu(), library(), GetParam()));
        const SyntheticScene all = SurfaceScene::seenBy(scene_);
        const SyntheticScene floor = [all](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> seen = all(origin, direction);
            return seen && seen->normalWS.y > 0.5 && seen->f0.x > 0 ? seen : std::nullopt;
        };
        gbuffer_ = SyntheticGBuffer::render(gpu(), floor, camera_, kWidth, kHeight);
        record();
    }
    void record() {
        run([&](VkCommandBuffer commands) {
            world_->rays.record(commands);
            world_->surfaces.record(commands);
        });
    }

    /// Reflected radiance: the mean of `frames` times `samples` paths.
    std::vector<float> picture(bool sampleLights, int samples, uint32_t frames, uint32_t seed) {
        settings_.rays.sampleLights = sampleLights;
        settings_.rays.samples = samples;
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings_);
        must(reflections.setInputs(gbuffer_.gbuffer, environment_.map));
        must(reflections.setRays(world_->rays, world_->surfaces));
        View view = camera_.view(kWidth, kHeight);
        view.seed = seed;
        HostImage shown;
        for (view.frameIndex = 0; view.frameIndex < frames; ++view.frameIndex)
            run([&](VkCommandBuffer commands) { reflections.record(commands, view); });
        run([&](VkCommandBuffer commands) { shown = must(reflections.recordView(commands, "reflection")); });
        return download(gpu(), shown);
    }

    /// One ray a pixel, averaged over 24 frames and neighbours.
    std::vector<float> denoised(bool sampleLights, bool screen) {
        const Settings before = settings_;
        settings_.rays.accumulate = false;
        settings_.denoise.enabled = true;
        settings_.screen.enabled = screen;
        std::vector<float> found = picture(sampleLights, 1, 24, 3);
        settings_ = before;
        return found;
    }

    /// Mean of several pictures, in blocks of pixels, with the standard error of that mean.
    struct Blocks {
        std::vector<double> mean;
        std::vector<double> error;
    };
    Blocks blocks(bool sampleLights, int samples, uint32_t pictures) {
        constexpr uint32_t kBlock = 4;
        constexpr uint32_t kColumns = kWidth / kBlock;
        std::vector<double> sums(size_t{kColumns} * (kHeight / kBlock), 0.0);
        std::vector<double> squares = sums;
        for (uint32_t i = 0; i < pictures; ++i) {
            const std::vector<float> found = picture(sampleLights, samples, 1, (sampleLights ? 100 : 500) + i);
            std::vector<double> means(sums.size(), 0.0);
            for (uint32_t y = 0; y < kHeight; ++y)
                for (uint32_t x = 0; x < kWidth; ++x)
                    means[size_t{y / kBlock} * kColumns + x / kBlock] +=
                        double(found[(size_t{y} * kWidth + x) * 4 + 1]) / (kBlock * kBlock);
            for (size_t block = 0; block < sums.size(); ++block) {
                sums[block] += means[block];
                squares[block] += means[block] * means[block];
            }
        }
        Blocks result;
        const double n = pictures;
        for (size_t block = 0; block < sums.size(); ++block) {
            const double mean = sums[block] / n;
            result.mean.push_back(mean);
            result.error.push_back(std::sqrt(std::max(squares[block] / n - mean * mean, 0.0) / (n - 1)));
        }
        return result;
    }

    /// The mean with and without rays to lights, within what noise allows.
    void expectSameMean(int samples) {
        constexpr uint32_t kPictures = 12;
        const Blocks with = blocks(true, samples, kPictures);
        const Blocks without = blocks(false, samples, kPictures);
        double withSum = 0;
        double withoutSum = 0;
        double variance = 0;
        for (size_t i = 0; i < with.mean.size(); ++i) {
            const double error = std::hypot(with.error[i], without.error[i]);
            // Student's distribution with 11 degrees of freedom: 6 of these in one of 10 000 blocks.
            EXPECT_NEAR(with.mean[i], without.mean[i], 6 * error + 1e-4) << "block " << i;
            withSum += with.mean[i];
            withoutSum += without.mean[i];
            variance += error * error;
        }
        EXPECT_NEAR(withSum, withoutSum, 4 * std::sqrt(variance));
        EXPECT_LT(std::sqrt(variance), 0.02 * withoutSum) << "too noisy to tell";
        std::cout << "mean " << withSum / double(with.mean.size()) << " with, " << withoutSum / double(with.mean.size())
                  << " without; standard error " << std::sqrt(variance) / double(with.mean.size()) << "\n";
    }

    /// Mean relative squared error of the pixels.
    static double error(const std::vector<float>& found, const std::vector<float>& truth) {
        double sum = 0;
        for (size_t i = 1; i < truth.size(); i += 4) {
            const double difference = double(found[i]) - double(truth[i]);
            sum += difference * difference / (double(truth[i]) * double(truth[i]) + 0.01);
        }
        return sum / (double(truth.size()) / 4);
    }
    /// How many times smaller the error of 16 samples is.
    double gain() {
        const std::vector<float> truth = picture(true, 128, 4, 1);
        const double with = error(picture(true, 16, 1, 2), truth);
        const double without = error(picture(false, 16, 1, 2), truth);
        std::cout << "16 samples, relative MSE: " << without << ", rays to lights " << with << "\n";
        return without / with;
    }

    Settings settings_;
    SurfaceScene scene_;
    TestEnvironment environment_;
    SyntheticCamera camera_ = {.position = {0, 1.5, 3}, .target = {0, 0, -0.5}};
    SyntheticGBuffer gbuffer_;
    std::optional<SurfaceScene::World> world_;
};

TEST_P(RaysSampleLightsTest, ASmallLampHasTheSameMean) {
    addFloor(0.6f);
    addLamp(0.5f, emitting({50, 40, 30}));
    scene_.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 4, 0}, whiteMetal(0.4f));
    build();
    expectSameMean(128);
}

TEST_P(RaysSampleLightsTest, ASmallLampHasLessNoise) {
    addFloor(0.6f);
    addLamp(0.2f, emitting({300, 300, 300}));
    build();
    EXPECT_GT(gain(), 20);
}

TEST_P(RaysSampleLightsTest, ALargeLampHasNoMoreNoise) {
    addFloor(0.3f);
    addLamp(5, emitting({1, 1, 1}));
    build();
    EXPECT_GT(gain(), 0.7);
}

TEST_P(RaysSampleLightsTest, ASunHasTheSameMean) {
    addFloor(0.5f);
    addSun(8, 200);
    scene_.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 2, 0}, blackMatte()); // shadows part of the floor
    build();
    expectSameMean(128);
}

TEST_P(RaysSampleLightsTest, ASunHasLessNoise) {
    addFloor(0.5f);
    addSun(1.5, 20000);
    build();
    EXPECT_GT(gain(), 20);
}

/// Also where the screen has answered the pixel's ray: the ray to the sun is sent all the same.
TEST_P(RaysSampleLightsTest, TheDenoiserJoinsASun) {
    addFloor(0.5f);
    addSun(3, 3000);
    scene_.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 0.6f, 0}, emitting({0.5f, 0.5f, 0.5f}));
    build();
    const SyntheticScene all = SurfaceScene::seenBy(scene_); // the screen sees the panel in the floor
    gbuffer_ = SyntheticGBuffer::render(gpu(), all, camera_, kWidth, kHeight);
    settings_.denoise.enabled = false;
    const std::vector<float> truth = picture(true, 128, 2, 1);
    const auto sum = [](const std::vector<float>& of) {
        double light = 0;
        for (size_t i = 1; i < of.size(); i += 4)
            light += double(of[i]);
        return light;
    };
    const std::vector<float> without = denoised(false, true);
    for (const bool screen : {false, true}) {
        const std::vector<float> with = denoised(true, screen);
        std::cout << "denoised, relative MSE: " << error(without, truth) << ", rays to the sky " << error(with, truth)
                  << "; energy " << sum(with) / sum(truth) << "\n";
        EXPECT_LT(error(with, truth), error(without, truth) / 4);
        EXPECT_NEAR(sum(with) / sum(truth), 1, 0.015);
    }
}

/// A mirror shows a rough wall in the sun: the wall sends the ray.
TEST_P(RaysSampleLightsTest, TheDenoiserJoinsASunBehindMirrors) {
    addFloor(0);
    addSun(3, 3000, {0.4, 0.8, 0.6});
    scene_.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 4, 0}, whiteMetal(0.5f));
    build();
    settings_.denoise.enabled = false;
    const std::vector<float> truth = picture(true, 128, 2, 1);
    const double with = error(denoised(true, false), truth);
    const double without = error(denoised(false, false), truth);
    std::cout << "denoised, relative MSE: " << without << ", rays to the sky " << with << "\n";
    EXPECT_LT(with, without / 4);
}

/// Light through glass, through holes and past single-sided faces reaches the path and the rays to lights alike.
TEST_P(RaysSampleLightsTest, GlassHolesAndBackFacesHaveTheSameMean) {
    addFloor(0.6f);
    addSun(20, 40);
    addLamp(0.8f, emitting({20, 20, 20}));
    scene_.triangles.instances.back().doubleSided = false;
    // A lamp that shows the floor its back: dark, as rays pass through it.
    scene_.addQuad({0.8f, 1, 0}, {0.8f, 0, 0}, {0, 0, -0.8f}, emitting({20, 20, 20}));
    scene_.triangles.instances.back().doubleSided = false;
    SurfaceMaterial glass = blackMatte();
    glass.baseColorFactor = {0.5f, 0.9f, 0.5f, 1};
    glass.transmissionFactor = 1;
    scene_.addQuad({-2, 0.6f, 0.5f}, {2, 0, 0}, {0, 0, -1}, glass);
    // Holes everywhere: the surface below its cutoff hides nothing.
    SurfaceMaterial holes = emitting({5, 5, 5});
    holes.alpha = SurfaceAlpha::Mask;
    holes.baseColorFactor = {0, 0, 0, 0.2f};
    scene_.addQuad({-0.2f, 0.5f, 0}, {1, 0, 0}, {0, 0, -1}, holes);
    scene_.triangles.instances.back().opaque = false;
    build();
    expectSameMean(128);
}

TEST_P(RaysSampleLightsTest, AWhiteFurnaceStaysWhite) {
    addFloor(0.7f);
    environment_ = TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(0.5f); });
    build();
    const std::vector<float> sky = picture(true, 4, 1, 3);
    size_t floor = 0;
    for (size_t i = 1; i < sky.size(); i += 4)
        if (sky[i] > 0) {
            EXPECT_NEAR(sky[i], 0.5, 1e-3) << "uniform light has no noise";
            ++floor;
        }
    EXPECT_GT(floor, size_t{kWidth} * kHeight / 2);
}

/// A closed box that emits the same light everywhere.
TEST_P(RaysSampleLightsTest, AFurnaceOfEmittersStaysWhite) {
    addFloor(0.7f);
    const SurfaceMaterial wall = emitting({0.5f, 0.5f, 0.5f});
    scene_.addQuad({-5, -1, -5}, {10, 0, 0}, {0, 8, 0}, wall);
    scene_.addQuad({5, -1, 5}, {-10, 0, 0}, {0, 8, 0}, wall);
    scene_.addQuad({-5, -1, 5}, {0, 0, -10}, {0, 8, 0}, wall);
    scene_.addQuad({5, -1, -5}, {0, 0, 10}, {0, 8, 0}, wall);
    scene_.addQuad({-5, 7, -5}, {10, 0, 0}, {0, 0, 10}, wall);
    build();
    const Blocks found = blocks(true, 32, 12);
    double sum = 0;
    double count = 0;
    for (size_t i = 0; i < found.mean.size(); ++i)
        if (found.error[i] > 0 && found.mean[i] > 0.4) {
            EXPECT_NEAR(found.mean[i], 0.5, 6 * found.error[i] + 1e-3);
            sum += found.mean[i];
            count += 1;
        }
    ASSERT_GT(count, 8);
    EXPECT_NEAR(sum / count, 0.5, 2e-3);
}

/// Lamps that move or change are sampled where they are.
TEST_P(RaysSampleLightsTest, AMovedLampIsSampledWhereItIs) {
    addFloor(0.6f);
    addLamp(0.2f, emitting({300, 300, 300}));
    build();
    const std::vector<float> before = picture(true, 64, 2, 4);
    const auto move = [&](float x) {
        std::vector<RayInstance> instances = scene_.triangles.instances;
        instances[1].localToWorld[12] = x;
        std::vector<SurfaceInstance> surfaces;
        for (uint32_t i = 0; i < instances.size(); ++i)
            surfaces.push_back({instances[i].mesh, i, instances[i].localToWorld});
        must(world_->rays.setInstances(instances));
        must(world_->surfaces.setInstances(surfaces));
        record();
    };
    move(1);
    const std::vector<float> moved = picture(true, 64, 2, 5);
    EXPECT_GT(error(moved, before), 0.1);
    EXPECT_GT(gain(), 20);
    move(0);
    EXPECT_LT(error(picture(true, 64, 2, 6), before), 0.01);
}

INSTANTIATE_TEST_SUITE_P(BackEnds, RaysSampleLightsTest, testing::Values(RayBackend::Bvh, RayBackend::Query),
                         [](const auto& parameter) { return parameter.param == RayBackend::Bvh ? "Bvh" : "Query"; });

} // namespace rays_sample_lights_test
} // namespace glint::test
