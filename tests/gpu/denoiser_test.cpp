// Rough reflections with denoise.enabled: one sampled direction a pixel, neighbours' rays, the mean over frames, the
// filter. Tests what must hold for any formula: energy, unbiased means, mirrors untouched, histories that follow the
// picture.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint::test {
namespace denoiser_test {

constexpr uint32_t kWidth = 80;
constexpr uint32_t kHeight = 48;

/// A floor of this roughness before a wall whose colour changes along x, from dark to bright.
SyntheticScene roughFloor(float perceptualRoughness) {
    Stage stage = floorAndWall();
    stage.floorRoughness = perceptualRoughness;
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(std::sin(2 * hit->radiance.x) > 0 ? 1.0f : 0.1f);
        return hit;
    };
}

/// A lamp that few of the floor's rays meet.
SyntheticScene roughFloorAndSmallLamp() {
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.5f;
    stage.cards.push_back({.low = {-0.06, 0.3}, .high = {0.06, 0.42}, .z = -1});
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(hit->distance * direction.z + origin.z > -2 ? 500.0f : 0.1f);
        return hit;
    };
}

class DenoiserTest : public LibraryTest {
protected:
    static Settings denoised() {
        Settings settings = plainSettings();
        settings.denoise.enabled = true;
        settings.reuse.rate = RayRate::Full; // tests of other rates say so
        settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
        return settings;
    }

    static SyntheticCamera cameraAt(double x) {
        SyntheticCamera camera;
        camera.position.x = x;
        return camera;
    }

    /// `frames` frames of a camera that moves by `step` metres a frame and ends where a camera at rest is.
    static Picture play(Reflections& made, const SyntheticScene& scene, uint32_t frames, double step, uint32_t seed,
                        uint32_t width = kWidth, uint32_t height = kHeight) {
        Picture last;
        for (uint32_t i = 0; i < frames; ++i) {
            const SyntheticCamera camera = cameraAt(-step * (frames - 1 - i));
            const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, width, height);
            must(made.setInputs(host.gbuffer));
            View view = camera.view(width, height);
            view.frameIndex = i;
            view.seed = seed;
            last = trace(made, view);
        }
        return last;
    }
    static Picture play(const Settings& settings, const SyntheticScene& scene, uint32_t frames, double step = 0,
                        uint32_t seed = 0) {
        Reflections made = reflections(kWidth, kHeight, settings);
        return play(made, scene, frames, step, seed);
    }

    /// Root of the mean squared difference of two reflections, where both have an answer.
    static double difference(const Picture& a, const Picture& b) {
        double sum = 0;
        size_t count = 0;
        for (size_t i = 0; i < a.pixels(); ++i)
            if (a.weight[i * 4] > 0.99f && b.weight[i * 4] > 0.99f) {
                const double apart = a.reflection[i * 4] - b.reflection[i * 4];
                sum += apart * apart;
                ++count;
            }
        EXPECT_GT(count, 300u);
        return std::sqrt(sum / static_cast<double>(std::max<size_t>(count, 1)));
    }
    static void expectSameBits(const std::vector<float>& a, const std::vector<float>& b) {
        ASSERT_EQ(a.size(), b.size());
        size_t different = 0;
        float most = 0;
        for (size_t i = 0; i < a.size(); ++i) {
            different += a[i] != b[i];
            most = std::max(most, std::abs(a[i] - b[i]));
        }
        EXPECT_EQ(different, 0u) << "of " << a.size() << ", by at most " << most;
    }
    static double sumOf(const Picture& picture) {
        double sum = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            sum += picture.reflection[i * 4];
        return sum;
    }

    /// Noise: half of the squared difference of two seeds.
    static double noise(const Settings& settings, const SyntheticScene& scene, uint32_t frames, double step = 0) {
        return difference(play(settings, scene, frames, step, 1), play(settings, scene, frames, step, 2)) /
               std::sqrt(2.0);
    }
};

TEST_F(DenoiserTest, mirrorsKeepTheirBits) {
    Settings off = denoised();
    off.denoise.enabled = false;
    Settings stabilized = denoised();
    stabilized.denoise.stabilizeSeconds = 1;
    for (const uint32_t frames : {1u, 4u}) {
        const Picture without = play(off, roughFloor(0), frames, 0.03);
        for (const Settings& settings : {denoised(), stabilized}) {
            const Picture with = play(settings, roughFloor(0), frames, 0.03);
            expectSameBits(with.composite, without.composite);
            expectSameBits(with.reflection, without.reflection);
        }
    }
}

TEST_F(DenoiserTest, uniformLightStaysUniform) {
    const TestEnvironment around =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    for (const auto& [perceptualRoughness, rate] :
         {std::pair(0.1f, RayRate::Full), std::pair(0.3f, RayRate::Full), std::pair(0.7f, RayRate::Full),
          std::pair(0.1f, RayRate::Quarter), std::pair(0.4f, RayRate::Checkerboard)}) {
        const SyntheticScene scene = litBy(roughFloor(perceptualRoughness), glm::vec3(1));
        Settings settings = denoised();
        settings.reuse.rate = rate;
        Reflections made = reflections(kWidth, kHeight, settings);
        for (uint32_t i = 0; i < 3; ++i) {
            const SyntheticCamera camera = cameraAt(0.05 * i);
            const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
            must(made.setInputs(host.gbuffer, around.map));
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = i;
            const Picture picture = trace(made, view);
            for (size_t pixel = 0; pixel < picture.pixels(); ++pixel)
                if (picture.weight[pixel * 4] > 0) {
                    ASSERT_NEAR(picture.reflection[pixel * 4], 1, 2e-3)
                        << "roughness " << perceptualRoughness << " frame " << i << " pixel " << pixel;
                }
        }
    }
}

TEST_F(DenoiserTest, noiseFallsAtRest) {
    const SyntheticScene scene = roughFloor(0.3f);
    Settings raw = denoised();
    raw.reuse.samples = 0;
    raw.denoise.historySeconds = 0;
    raw.denoise.maxRadius = 0;
    const double one = noise(raw, scene, 1);
    EXPECT_GT(one, 0.1) << "a ray a pixel is noise";
    Settings overFrames = raw;
    overFrames.denoise.historySeconds = 4;
    EXPECT_NEAR(noise(overFrames, scene, 16) / one, 0.25, 0.05) << "the mean of 16 samples";
    Settings neighbours = raw;
    neighbours.reuse.samples = 8;
    EXPECT_LT(noise(neighbours, scene, 1), 0.6 * one);
    EXPECT_LT(noise(denoised(), scene, 16), 0.1 * one);
    EXPECT_LT(noise(denoised(), scene, 1), 0.35 * one) << "the first frame is smoothed";
}

TEST_F(DenoiserTest, neighboursAndFilterKeepTheMean) {
    const SyntheticScene scene = roughFloor(0.25f);
    Settings own = denoised();
    own.reuse.samples = 0;
    own.denoise.maxRadius = 0;
    own.denoise.historySeconds = 4;
    Settings all = denoised();
    all.denoise.historySeconds = 4;
    const Picture truth = play(own, scene, 128);
    const Picture picture = play(all, scene, 32);
    EXPECT_LT(difference(picture, truth), 0.04);
    EXPECT_NEAR(sumOf(picture) / sumOf(truth), 1, 0.01);
}

TEST_F(DenoiserTest, theFilterKeepsWhatShortHistoriesShow) {
    // Histories as short as motion leaves them are all noise to the filter, which is then as wide as it may be.
    const SyntheticScene scene = roughFloor(0.7f);
    Settings settings = denoised();
    settings.denoise.historySeconds = 5.0f / 60;
    const auto meanOf = [&](const Settings& of) {
        constexpr uint32_t kSeeds = 16;
        Picture mean = play(of, scene, 8, 0, 1);
        for (uint32_t seed = 2; seed <= kSeeds; ++seed) {
            const Picture one = play(of, scene, 8, 0, seed);
            for (size_t i = 0; i < mean.reflection.size(); ++i)
                mean.reflection[i] += (one.reflection[i] - mean.reflection[i]) / static_cast<float>(seed);
        }
        return mean;
    };
    Settings unfiltered = settings;
    unfiltered.denoise.maxRadius = 0;
    const Picture filtered = meanOf(settings);
    const Picture truth = meanOf(unfiltered);
    constexpr size_t kApart = 3; // pixels
    double same = 0;             // of the gradients along x
    double whole = 0;
    for (size_t i = 0; i + kApart < truth.pixels(); ++i) {
        const size_t left = 4 * i, right = 4 * (i + kApart);
        if (i % kWidth + kApart >= kWidth || truth.weight[left] <= 0.99f || truth.weight[right] <= 0.99f)
            continue;
        const double gradient = truth.reflection[right] - truth.reflection[left];
        same += gradient * (filtered.reflection[right] - filtered.reflection[left]);
        whole += gradient * gradient;
    }
    std::cout << "gradients after the filter: " << same / whole << " of those before\n";
    EXPECT_GT(same / whole, 0.77) << "0.74 if the filter is half of the lobe wide";
}

TEST_F(DenoiserTest, stabilizingHoldsStillWhatIsShown) {
    const SyntheticScene scene = roughFloor(0.3f);
    Settings stabilized = denoised();
    stabilized.denoise.stabilizeSeconds = 0.5f;
    /// From the 36th frame of a view at rest to the 37th.
    const auto flicker = [&](const Settings& settings) {
        Reflections made = reflections(kWidth, kHeight, settings);
        const Picture before = play(made, scene, 36, 0, 0);
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, cameraAt(0), kWidth, kHeight);
        must(made.setInputs(host.gbuffer));
        View view = cameraAt(0).view(kWidth, kHeight);
        view.frameIndex = 36;
        return difference(trace(made, view), before);
    };
    EXPECT_LT(flicker(stabilized), 0.25 * flicker(denoised()));
    for (const double step : {0.0, 0.02})
        EXPECT_NEAR(sumOf(play(stabilized, scene, 30, step)) / sumOf(play(denoised(), scene, 30, step)), 1, 0.01)
            << step;
}

TEST_F(DenoiserTest, aLongMeanLosesNoLight) {
    // Rounding down to 16 bits in every frame would take 2.8 % in 200 frames.
    const SyntheticScene scene = roughFloor(0.25f);
    Settings settings = denoised();
    settings.denoise.historySeconds = 4;
    settings.reuse.samples = 0;
    settings.denoise.maxRadius = 0;
    EXPECT_NEAR(sumOf(play(settings, scene, 200)) / sumOf(play(settings, scene, 16)), 1, 0.002);
}

TEST_F(DenoiserTest, pixelsWithoutNeighboursWeighTheirRaysToo) {
    // Far from the mirror direction facets shadow one another: samples there count less.
    const SyntheticScene scene = roughFloor(0.6f);
    Settings settings = denoised();
    settings.denoise.historySeconds = 4;
    settings.denoise.maxRadius = 0;
    const Picture all = play(settings, scene, 96);
    settings.reuse.samples = 0;
    const Picture own = play(settings, scene, 96);
    // Neighbours' rays are carried without the slope of what they met, which costs 1 %.
    EXPECT_NEAR(sumOf(own) / sumOf(all), 1, 0.015);
}

TEST_F(DenoiserTest, aMovingCameraKeepsItsHistory) {
    for (const float perceptualRoughness : {0.15f, 0.4f}) {
        const SyntheticScene scene = roughFloor(perceptualRoughness);
        Settings settings = denoised();
        settings.denoise.maxRadius = 0;
        Settings forgets = settings;
        forgets.denoise.historySeconds = 0;
        const double kept = noise(settings, scene, 16, 0.02);
        const double fresh = noise(forgets, scene, 16, 0.02);
        EXPECT_LT(kept, 0.6 * fresh) << perceptualRoughness;
        // And it shows what a camera at rest sees there.
        const Picture moved = play(settings, scene, 16, 0.02);
        const Picture rested = play(settings, scene, 64);
        EXPECT_LT(difference(moved, rested), fresh) << perceptualRoughness;
    }
}

TEST_F(DenoiserTest, whatIsReflectedStaysSharpInMotion) {
    // Thin bars. Every frame shifts them by a fraction of a pixel, and every mix of neighbours would blur them further.
    const SyntheticScene scene = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        Stage stage = floorAndWall();
        stage.floorRoughness = 0.12f;
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(std::sin(8 * (origin.x + hit->distance * direction.x)) > 0 ? 1.0f : 0.3f);
        return hit;
    };
    Settings settings = denoised();
    settings.denoise.maxRadius = 0;
    const Picture rested = play(settings, scene, 64);
    const Picture moved = play(settings, scene, 24, 0.013);
    double same = 0; // of the gradients along x
    double whole = 0;
    for (size_t i = 0; i + 1 < rested.pixels(); ++i)
        if ((i + 1) % kWidth != 0 && rested.weight[i * 4] > 0.99f && rested.weight[i * 4 + 4] > 0.99f) {
            const double gradient = rested.reflection[i * 4 + 4] - rested.reflection[i * 4];
            same += gradient * (moved.reflection[i * 4 + 4] - moved.reflection[i * 4]);
            whole += gradient * gradient;
        }
    std::cout << "gradients in motion: " << same / whole << " of those at rest\n";
    EXPECT_GT(same / whole, 0.58) << "0.45 if texels are mixed linearly";
}

TEST_F(DenoiserTest, rareBrightPointsAreDimmed) {
    const SyntheticScene scene = roughFloorAndSmallLamp();
    Settings all = denoised();
    all.denoise.firefly = 0;
    Settings dimmed = denoised();
    EXPECT_LT(noise(dimmed, scene, 30), 0.85 * noise(all, scene, 30));
    EXPECT_GT(sumOf(play(dimmed, scene, 30)), 0.5 * sumOf(play(all, scene, 30)));
    for (const float perceptualRoughness : {0.15f, 0.3f, 0.6f}) {
        const SyntheticScene even = roughFloor(perceptualRoughness);
        for (const double step : {0.0, 0.02})
            EXPECT_NEAR(sumOf(play(dimmed, even, 30, step)) / sumOf(play(all, even, 30, step)), 1, 0.003)
                << "no light is lost that many rays find, roughness " << perceptualRoughness << ", step " << step;
    }
}

TEST_F(DenoiserTest, aThinLampBeforeAWallKeepsItsPlaceInMotion) {
    // Most rays miss the lamp, most light comes from it. Taken to be as far as the wall, its image would smear.
    const SyntheticScene scene = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        Stage stage = floorAndWall();
        stage.floorRoughness = 0.1f;
        stage.cards.push_back({.low = {-0.1, 0.1}, .high = {0.1, 2}, .z = -1});
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = glm::vec3(hit->distance * direction.z + origin.z > -2 ? 20.0f : 0.1f);
        return hit;
    };
    Settings settings = denoised();
    settings.denoise.maxRadius = 0;
    const Picture rested = play(settings, scene, 64);
    const Picture moved = play(settings, scene, 16, 0.04);
    // With distances not weighed by light: 1.70 and 1.72.
    EXPECT_LT(difference(moved, rested), 1.45);
    EXPECT_LT(sumOf(moved) / sumOf(rested), 1.5);
}

TEST_F(DenoiserTest, whatWasHiddenHasNoHistory) {
    // A card before the floor moves away: the floor that it hid is new. Pixels count their frames.
    const auto withCard = [](double x) -> SyntheticScene {
        Stage stage = floorAndWall();
        stage.floorRoughness = 0.2f;
        stage.cards.push_back({.low = {x - 0.2, -1}, .high = {x + 0.2, 0.5}, .z = -1});
        return stage;
    };
    Reflections made = reflections(kWidth, kHeight, denoised());
    std::vector<float> frames;
    const auto frame = [&](const SyntheticScene& scene, uint32_t index) {
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, cameraAt(0), kWidth, kHeight);
        must(made.setInputs(host.gbuffer));
        View view = cameraAt(0).view(kWidth, kHeight);
        view.frameIndex = index;
        trace(made, view);
        frames = readView(made, "historyFrames");
    };
    for (uint32_t i = 0; i < 6; ++i)
        frame(withCard(0), i);
    const std::vector<float> before = frames;
    frame(withCard(0.6), 6);
    size_t uncovered = 0;
    size_t kept = 0;
    for (size_t i = 0; i < before.size(); i += 4) {
        if (before[i] == 0 && frames[i] > 0) {
            EXPECT_LT(frames[i], 2) << "pixel " << i / 4; // frames count by what they show of the lobe: 1 on average
            ++uncovered;
        }
        kept += before[i] > 4 && frames[i] > before[i] ? 1 : 0;
    }
    EXPECT_GT(uncovered, 20u);
    EXPECT_GT(kept, 1500u);
}

TEST_F(DenoiserTest, viewsShowWhichPixelsSendRaysAndHowManyFramesCount) {
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), roughFloor(0.5f), cameraAt(0), kWidth, kHeight);
    for (const auto& [rate, share] : {std::pair(RayRate::Full, 1.0), {RayRate::Checkerboard, 0.5}}) {
        Settings settings = denoised();
        settings.reuse.rate = rate;
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(host.gbuffer));
        View view = cameraAt(0).view(kWidth, kHeight);
        for (view.frameIndex = 0; view.frameIndex < 4; ++view.frameIndex)
            trace(made, view);
        const std::vector<float> frames = readView(made, "historyFrames");
        const std::vector<float> rays = readView(made, "raySent");
        const std::vector<float> roughness = readView(made, "roughness");
        size_t sent = 0;
        size_t floor = 0;
        double counted = 0;
        for (size_t i = 0; i < rays.size(); i += 4) {
            if (std::abs(roughness[i] - 0.5f) > 0.01f) { // nothing is reflected there
                EXPECT_EQ(rays[i], 0) << i / 4;
                EXPECT_EQ(frames[i], 0) << i / 4;
                continue;
            }
            ++floor;
            sent += rays[i] == 1 ? 1 : 0;
            EXPECT_TRUE(rays[i] == 1 || rays[i] == 0.25f) << rays[i];
            counted += double(frames[i]);
        }
        ASSERT_GT(floor, 1000u);
        if (rate == RayRate::Full) {
            EXPECT_NEAR(counted / double(floor), 4, 0.1); // each by what it shows of the lobe: 1 on average
        }
        EXPECT_NEAR(static_cast<double>(sent) / static_cast<double>(floor), share, 0.1);
        settings.denoise.enabled = false;
        must(made.setSettings(settings));
        trace(made, view);
        for (const char* name : {"historyFrames", "antilag", "raySent"}) {
            const std::vector<float> none = readView(made, name);
            for (size_t i = 0; i < none.size(); ++i)
                ASSERT_EQ(none[i], i % 4 == 3 ? 1 : 0) << name; // alpha
        }
    }
}

TEST_F(DenoiserTest, whatIsNoNumberDoesNotStay) {
    const SyntheticScene scene = roughFloor(0.3f);
    const SyntheticScene broken = [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = scene(origin, direction);
        if (hit && hit->f0.x == 0 && std::abs(direction.x) < 0.05)
            hit->radiance =
                glm::vec3(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e9f);
        return hit;
    };
    Reflections made = reflections(kWidth, kHeight, denoised());
    uint32_t index = 0;
    for (const SyntheticScene* shown : {&broken, &scene, &scene}) {
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), *shown, cameraAt(0), kWidth, kHeight);
        must(made.setInputs(host.gbuffer));
        View view = cameraAt(0).view(kWidth, kHeight);
        view.frameIndex = index++;
        for (const float value : trace(made, view).reflection)
            ASSERT_TRUE(std::isfinite(value)) << "frame " << index;
    }
}

TEST_F(DenoiserTest, sameSeedSameBits) {
    const SyntheticScene scene = roughFloor(0.3f);
    EXPECT_EQ(play(denoised(), scene, 8, 0.02, 3).composite, play(denoised(), scene, 8, 0.02, 3).composite);
    EXPECT_NE(play(denoised(), scene, 8, 0.02, 3).composite, play(denoised(), scene, 8, 0.02, 4).composite);
    for (const auto& [width, height] : {std::pair(1u, 1u), {7u, 5u}, {17u, 9u}}) {
        Reflections made = reflections(width, height, denoised());
        for (const float value : play(made, scene, 3, 0.02, 0, width, height).composite)
            ASSERT_TRUE(std::isfinite(value)) << width;
    }
}

TEST_F(DenoiserTest, settingsStartAnewAndSwitchOff) {
    const SyntheticScene scene = roughFloor(0.3f);
    Reflections made = reflections(kWidth, kHeight, denoised());
    const Picture first = play(made, scene, 1, 0, 0);
    play(made, scene, 5, 0, 0);
    must(made.setSettings(denoised()));
    EXPECT_EQ(play(made, scene, 1, 0, 0).composite, first.composite);
    Settings off = denoised();
    off.denoise.enabled = false;
    must(made.setSettings(off));
    EXPECT_EQ(play(made, scene, 1, 0, 0).composite, play(off, scene, 1).composite);
    must(made.setSettings(denoised()));
    EXPECT_EQ(play(made, scene, 1, 0, 0).composite, first.composite);
}

TEST_F(DenoiserTest, aCutHasNoHistory) {
    for (const ColorSource colors : {ColorSource::Current, ColorSource::Previous}) {
        Settings settings = denoised();
        settings.screen.colorSource = colors;
        const SyntheticCamera camera = cameraAt(0);
        const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), roughFloor(0.3f), camera, kWidth, kHeight);
        const auto last = [&](std::vector<uint32_t> frames, bool cut) {
            Reflections made = reflections(kWidth, kHeight, settings);
            must(made.setInputs(host.gbuffer));
            Picture picture;
            for (const uint32_t frame : frames) {
                View view = camera.view(kWidth, kHeight);
                view.frameIndex = frame;
                view.cut = cut && frame == frames.back();
                picture = trace(made, view);
            }
            return picture.composite;
        };
        EXPECT_EQ(last({0, 1, 2, 3}, true), last({3}, false));
        EXPECT_NE(last({0, 1, 2, 3}, false), last({3}, false));
    }
}

TEST_F(DenoiserTest, everySettingActs) {
    const auto acts = [&](const SyntheticScene& scene, const char* key, const char* value) {
        Settings settings = denoised();
        must(set(settings, key, value));
        EXPECT_NE(play(settings, scene, 4, 0.05).composite, play(denoised(), scene, 4, 0.05).composite) << key;
    };
    const SyntheticScene floor = roughFloor(0.2f);
    acts(floor, "reuse.samples", "4");
    acts(floor, "reuse.radius", "2");
    acts(floor, "reuse.rate", "checkerboard");
    acts(floor, "denoise.historySeconds", "0.02");
    acts(floor, "denoise.lobeTrail", "0.05");
    acts(roughFloorAndSmallLamp(), "denoise.firefly", "1");
    acts(floor, "denoise.maxRadius", "2");
    acts(floor, "denoise.noiseTarget", "0.5");
    acts(floor, "denoise.virtualMotion", "surface");
    acts(floor, "denoise.stabilizeSeconds", "0.5");
    // Two rough surfaces with one normal, one behind the other.
    Stage step = floorAndWall();
    step.cards[0].f0 = 0.5f;
    step.cards[0].perceptualRoughness = 0.2f;
    step.cards.push_back({.low = {-0.5, -1}, .high = {0.5, 3}, .z = -2.7, .f0 = 0.5f, .perceptualRoughness = 0.2f});
    acts(step, "denoise.disocclusion", "0.2");
}

// ---------------------------------------------------------------- reuse.rate

constexpr std::pair<RayRate, double> kRates[] = {
    {RayRate::Full, 1}, {RayRate::Checkerboard, 0.5}, {RayRate::Quarter, 0.25}};

TEST_F(DenoiserTest, eachPixelSendsARayInItsTurn) {
    const SyntheticScene scene = roughFloor(0.6f);
    const SyntheticCamera camera = cameraAt(0);
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), scene, camera, kWidth, kHeight);
    for (const auto& [rate, share] : kRates) {
        Settings settings = denoised();
        settings.reuse.rate = rate;
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(host.gbuffer));
        const auto turns = static_cast<uint32_t>(1 / share);
        std::vector<uint32_t> sent(size_t{kWidth} * kHeight);
        std::vector<uint32_t> reflects(sent.size());
        for (uint32_t frame = 0; frame < turns; ++frame) {
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = frame;
            const Picture picture = trace(made, view);
            for (size_t i = 0; i < sent.size(); ++i) {
                sent[i] += reflect::isTraced(picture.outcome(i)) ? 1 : 0;
                reflects[i] += picture.outcome(i) == shared::kOutcomeFromNeighbours ? 1 : 0;
            }
        }
        size_t pixels = 0;
        for (size_t i = 0; i < sent.size(); ++i)
            if (sent[i] + reflects[i] > 0) {
                ASSERT_EQ(sent[i], 1u) << "rate " << share << ", pixel " << i % kWidth << "," << i / kWidth;
                ASSERT_EQ(reflects[i], turns - 1);
                ++pixels;
            }
        EXPECT_GT(pixels, 1000u);
    }
}

TEST_F(DenoiserTest, narrowLobesSendEveryFrame) {
    for (const float perceptualRoughness : {0.0f, 0.02f}) {
        Settings quarter = denoised();
        quarter.reuse.rate = RayRate::Quarter;
        EXPECT_EQ(play(quarter, roughFloor(perceptualRoughness), 3, 0.03).composite,
                  play(denoised(), roughFloor(perceptualRoughness), 3, 0.03).composite)
            << perceptualRoughness;
    }
}

TEST_F(DenoiserTest, fewerRaysKeepTheMean) {
    const SyntheticScene scene = roughFloor(0.5f); // wide enough on screen for a quarter
    Settings settings = denoised();
    settings.denoise.historySeconds = 4;
    const Picture full = play(settings, scene, 64);
    for (const RayRate rate : {RayRate::Checkerboard, RayRate::Quarter, RayRate::Adaptive}) {
        settings.reuse.rate = rate;
        const Picture fewer = play(settings, scene, 64);
        EXPECT_NEAR(sumOf(fewer) / sumOf(full), 1, 0.01);
        double apart = 0;
        for (size_t i = 0; i < full.pixels(); ++i) {
            const double difference = fewer.reflection[i * 4] - full.reflection[i * 4];
            apart += difference * difference;
        }
        EXPECT_LT(std::sqrt(apart / static_cast<double>(full.pixels())), 0.03)
            << "two seeds at the full rate are 0.010 apart";
    }
}

TEST_F(DenoiserTest, everyPixelFindsARayFromTheFirstFrameOn) {
    Stage stage = floorAndWall(); // with a pole of two pixels that reflects, too
    stage.floorRoughness = 0.6f;
    stage.cards.push_back({.low = {-0.5, -1}, .high = {-0.42, 3}, .z = -1, .f0 = 0.5f, .perceptualRoughness = 0.6f});
    for (const RayRate rate : {RayRate::Checkerboard, RayRate::Quarter}) {
        Settings settings = denoised();
        settings.reuse.rate = rate;
        Reflections made = reflections(kWidth, kHeight, settings);
        const Picture picture = play(made, stage, 1, 0, 0);
        HostImage meta;
        run([&](VkCommandBuffer commands) { meta = must(made.recordView(commands, "denoise/accumulate:meta")); });
        const std::vector<float> frames = download(gpu(), meta);
        size_t without = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            if (picture.outcome(i) == shared::kOutcomeFromNeighbours && frames[i * 4] == 0)
                ++without;
        EXPECT_EQ(without, 0u);
    }
}

TEST_F(DenoiserTest, anAdaptiveRateFallsWhereThePictureHasSettled) {
    Settings settings = denoised();
    settings.reuse.rate = RayRate::Adaptive;
    const auto rays = [&](const SyntheticScene& scene, uint32_t frames, double step) {
        return static_cast<double>(play(settings, scene, frames, step).statistics.rays) /
               static_cast<double>(play(denoised(), scene, 1).statistics.rays);
    };
    const SyntheticScene even = litBy(roughFloor(0.9f), glm::vec3(1));
    EXPECT_EQ(rays(even, 1, 0), 1) << "nothing is known yet";
    settings.denoise.noiseTarget = 0.5f;
    EXPECT_NEAR(rays(even, 12, 0), 0.25, 0.05) << "where that much noise may be";
    settings.denoise.noiseTarget = 0.05f;
    EXPECT_GT(rays(roughFloor(0.3f), 6, 0), 0.9) << "with more than twice the noise that may be";
    settings.denoise.noiseTarget = 0.2f;
    EXPECT_NEAR(rays(roughFloor(0.3f), 6, 0), 0.5, 0.2) << "with less noise, on lobes narrower than eight pixels";
}

} // namespace denoiser_test
} // namespace glint::test
