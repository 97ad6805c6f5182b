// Path space regularization of the source `rays`: a rough floor before a smooth wall that reflects a point light.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <cmath>
#include <numeric>

namespace glint::test {
namespace rays_regularization_test {

constexpr uint32_t kWidth = 32;
constexpr uint32_t kHeight = 20;

struct Errors {
    double mean = 0;
    double energy = 0; ///< mean radiance relative to the reference's
};

class RaysRegularizationTest : public LibraryTest {
protected:
    void build(float wallRoughness, float floorRoughness = 0.4f) {
        scene_.addQuad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, whiteMetal(floorRoughness));
        scene_.addQuad({-3, 0, -3}, {6, 0, 0}, {0, 4, 0}, whiteMetal(wallRoughness));
        SurfaceLight light;
        light.kind = SurfaceLightKind::Point;
        light.color = {20, 20, 20};
        light.positionWS = {0.5f, 2, -1};
        light.castsShadow = false;
        scene_.lights.push_back(light);
        world_.emplace(scene_.build(gpu(), library(), RayBackend::Bvh));
        const SyntheticScene all = SurfaceScene::seenBy(scene_);
        const SyntheticScene floor = [all](const glm::dvec3& origin, const glm::dvec3& direction) {
            std::optional<SyntheticSurface> seen = all(origin, direction);
            return seen && seen->normalWS.y > 0.5 ? seen : std::nullopt;
        };
        gbuffer_ = SyntheticGBuffer::render(gpu(), floor, camera_, kWidth, kHeight);
        run([&](VkCommandBuffer commands) {
            world_->rays.record(commands);
            world_->surfaces.record(commands);
        });
    }

    /// The mean of `frames` times `samples` paths.
    std::vector<float> picture(float regularization, int samples, uint32_t frames, uint32_t seed) {
        Settings settings;
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.accumulate = true;
        settings.rays.samples = samples;
        settings.rays.regularization = regularization;
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(gbuffer_.gbuffer));
        must(reflections.setRays(world_->rays, world_->surfaces));
        View view = camera_.view(kWidth, kHeight);
        view.seed = seed;
        for (view.frameIndex = 0; view.frameIndex + 1 < frames; ++view.frameIndex)
            run([&](VkCommandBuffer commands) { reflections.record(commands, view); });
        return trace(reflections, view).reflection;
    }

    /// What the last frame adds to the denoiser's mean.
    std::vector<float> lastOf(uint32_t frames, float regularization, float historySeconds) {
        Settings settings;
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.bounces = 3;
        settings.rays.regularization = regularization;
        settings.denoise.enabled = true;
        settings.denoise.historySeconds = historySeconds;
        settings.reuse.rate = RayRate::Full;
        Reflections reflections = LibraryTest::reflections(kWidth, kHeight, settings);
        must(reflections.setInputs(gbuffer_.gbuffer));
        must(reflections.setRays(world_->rays, world_->surfaces));
        View view = camera_.view(kWidth, kHeight);
        for (view.frameIndex = 0; view.frameIndex < frames; ++view.frameIndex)
            run([&](VkCommandBuffer commands) { reflections.record(commands, view); });
        std::vector<float> noisy = readView(reflections, "denoise/gather:noisy");
        const std::vector<float> sent = readView(reflections, "raySent");
        for (size_t i = 0; i < noisy.size(); ++i)
            noisy[i] = sent[i - i % 4] == 1 ? noisy[i] : 0; // nothing is written elsewhere
        return noisy;
    }

    /// Four frames in the denoiser's mean blur as four samples do. Frames count by what they show of the lobe, so their
    /// number scatters around four.
    void expectFramesToCountAsSamples() {
        const std::vector<float> without = lastOf(4, 1, 0);
        const Errors ofHistory = compare(lastOf(4, 1, 0.5f), without);
        const Errors ofSamples = compare(lastOf(4, std::pow(4.f, -1.f / 6), 0), without);
        EXPECT_GT(ofHistory.mean, 0);
        EXPECT_NEAR(ofHistory.mean, ofSamples.mean, 0.05 * ofSamples.mean);
        EXPECT_EQ(lastOf(1, 1, 0.5f), lastOf(1, 1, 0)); // a first frame has no history
    }

    /// The default regularization divides the error of 16 samples by `factor` or more.
    void expectLessError(double factor) {
        const std::vector<float> truth = picture(0, 256, 32, 1);
        // Few pictures hold most of the error: the mean over many of them is no matter of luck.
        constexpr uint32_t kPictures = 32;
        double without = 0;
        double with = 0;
        for (uint32_t seed = 2; seed < 2 + kPictures; ++seed) {
            without += compare(picture(0, 16, 1, seed), truth).mean / kPictures;
            with += compare(picture(Settings().rays.regularization, 16, 1, seed), truth).mean / kPictures;
        }
        std::cout << "16 samples, relative MSE: " << without << ", regularized " << with << "\n";
        EXPECT_LT(with, without / factor);
    }

    static Errors compare(const std::vector<float>& found, const std::vector<float>& truth) {
        std::vector<double> errors;
        double shown = 0;
        double right = 0;
        for (size_t i = 0; i < truth.size(); i += 4) {
            const double difference = double(found[i]) - double(truth[i]);
            errors.push_back(difference * difference / (double(truth[i]) * double(truth[i]) + 0.01));
            shown += double(found[i]);
            right += double(truth[i]);
        }
        return {std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size()), shown / right};
    }

    SurfaceScene scene_;
    SyntheticCamera camera_ = {.position = {0, 1.5, 3}, .target = {0, 0, -0.5}};
    SyntheticGBuffer gbuffer_;
    std::optional<SurfaceScene::World> world_;
};

TEST_F(RaysRegularizationTest, fewSamplesHaveNoFireflies) {
    build(0.1f);
    expectLessError(5);
}

/// Of a narrow lobe only the tail finds the highlight.
TEST_F(RaysRegularizationTest, theTailOfANarrowLobeHasNoFireflies) {
    build(0.1f, 0.15f);
    expectLessError(5);
}

TEST_F(RaysRegularizationTest, energyIsKept) {
    build(0.2f); // wide enough for a reference without noise
    const std::vector<float> truth = picture(0, 256, 16, 1);
    EXPECT_NEAR(compare(picture(0.5f, 256, 4, 2), truth).energy, 1, 0.03);
}

TEST_F(RaysRegularizationTest, theBlurVanishesAsSamplesAddUp) {
    build(0.15f);
    const std::vector<float> truth = picture(0, 256, 32, 1);
    const Errors few = compare(picture(1, 256, 1, 2), truth);
    const Errors many = compare(picture(1, 256, 32, 2), truth);
    std::cout << "256 samples: " << few.mean << ", 8192: " << many.mean << "\n";
    EXPECT_LT(many.mean, few.mean / 2); // the squared bias falls by 32^(2/3) = 10, and noise with it
}

TEST_F(RaysRegularizationTest, aHistoryOfFramesCountsAsSamples) {
    build(0.15f);
    expectFramesToCountAsSamples();
}

TEST_F(RaysRegularizationTest, aMirrorsHistoryIsThatOfWhatItShows) {
    build(0.4f, 0); // from the floor to the wall, and back to a light in the floor
    expectFramesToCountAsSamples();
}

} // namespace rays_regularization_test
} // namespace glint::test
