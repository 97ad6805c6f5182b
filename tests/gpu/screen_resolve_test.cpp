// The stage `resolve`: upsampling of a smaller trace, the blur, the intermediate format. Tests what must hold for any
// formula: mirrors stay sharp, no light bleeds in from untraced pixels, and energy is conserved.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace screen_resolve_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;

class ScreenResolveTest : public LibraryTest {
protected:
    static Picture show(const SyntheticScene& scene, const Settings& settings) {
        return trace(scene, SyntheticCamera{}, kWidth, kHeight, settings);
    }

    static glm::vec3 reflected(const Picture& picture, size_t pixel) {
        return {picture.reflection[pixel * 4], picture.reflection[pixel * 4 + 1], picture.reflection[pixel * 4 + 2]};
    }

    /// Radiance before multiplication by its weight.
    static glm::vec3 answered(const Picture& picture, size_t pixel) {
        return reflected(picture, pixel) / picture.weight[pixel * 4];
    }
};

/// A floor of this roughness before a wall of one colour; rays over the wall's upper edge miss.
SyntheticScene uniformWall(float floorRoughness, const glm::vec3& radiance) {
    Stage stage;
    stage.floorRoughness = floorRoughness;
    stage.cards.push_back({.low = {-1, 0}, .high = {1, 0.6}, .z = -3});
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = radiance;
        return hit;
    };
}

/// A wall in two colours with the border at x = 0.
SyntheticScene twoColours(float floorRoughness) {
    Stage stage = floorAndWall();
    stage.floorRoughness = floorRoughness;
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0)
            hit->radiance = hit->radiance.x < 10 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        return hit;
    };
}

// ---------------------------------------------------------------- screen.resolutionScale

TEST_F(ScreenResolveTest, resolutionScaleTracesFewerRays) {
    Settings settings = plainSettings();
    const Picture whole = show(floorAndWall(), settings);
    settings.screen.resolutionScale = 0.5f;
    const Picture half = show(floorAndWall(), settings);
    EXPECT_NEAR(static_cast<double>(half.statistics.rays), static_cast<double>(whole.statistics.rays) / 4,
                static_cast<double>(whole.statistics.rays) * 0.02);
    uint64_t pixels = 0;
    for (const Statistics::Outcome& outcome : half.statistics.outcomes)
        pixels += outcome.count;
    EXPECT_EQ(pixels, 61u * 34u) << "every traced pixel has exactly one outcome, and no other is counted";
}

TEST_F(ScreenResolveTest, mirrorsOfASmallerTraceStaySharp) {
    // The wall shows its own position, so a colour is a hit position: a pixel of the full trace is 0.077 m there, and a
    // hit on the border of two pixels, or the corner of four, may show any of them.
    constexpr float kPixel = 0.077f;
    constexpr float kHalfStep = 1.0f / 128; // of a colour of 8 to 16, stored as a half
    Settings settings = plainSettings();
    const Picture whole = show(floorAndWall(), settings);
    for (const float scale : {0.7f, 0.5f, 0.25f}) {
        settings.screen.resolutionScale = scale;
        const Picture small = show(floorAndWall(), settings);
        size_t compared = 0;
        size_t kept = 0;
        size_t moved = 0;
        for (size_t i = 0; i < whole.pixels(); ++i) {
            if (!whole.hit(i) || whole.hitDistance[i * 4] < 1e-3f)
                continue; // the floor's last row may start on the wall itself
            ++compared;
            if (small.weight[i * 4] < 0.99f)
                continue; // at the wall's end a coarse trace may miss
            ++kept;
            const float apart = glm::length(answered(small, i) - answered(whole, i));
            ASSERT_LT(apart, 1.5f * kPixel + kHalfStep)
                << "scale " << scale << ", pixel " << i % kWidth << "," << i / kWidth;
            moved += apart > kPixel / 2;
        }
        EXPECT_GT(compared, 1000u);
        EXPECT_GE(kept, compared * 98 / 100) << scale;
        EXPECT_LE(moved, compared / 100) << scale;
    }
}

TEST_F(ScreenResolveTest, edgesOfWhatIsReflectedStayWhereTheyAre) {
    Settings settings = plainSettings();
    const Picture whole = show(twoColours(0), settings);
    settings.screen.resolutionScale = 0.5f;
    const Picture half = show(twoColours(0), settings);
    size_t differ = 0;
    size_t compared = 0;
    for (size_t i = 0; i < whole.pixels(); ++i)
        if (whole.hit(i) && half.weight[i * 4] > 0.99f) {
            ++compared;
            differ += glm::length(reflected(half, i) - reflected(whole, i)) > 0.1f;
        }
    EXPECT_GT(compared, 1000u);
    EXPECT_LE(differ, compared / 200);
}

TEST_F(ScreenResolveTest, whatDoesNotReflectGetsNothingFromItsNeighbours) {
    const SyntheticCamera camera;
    for (const float strength : {0.0f, 0.3f})
        for (const float scale : {1.0f, 0.5f, 0.3f}) {
            Settings settings = plainSettings();
            settings.blur.strength = strength;
            settings.screen.resolutionScale = scale;
            Stage stage = floorAndWall();
            stage.floorRoughness = 0.2f;
            stage.cards.push_back({.low = {-0.3, 0}, .high = {0.3, 0.4}, .z = 1}); // does not reflect
            const Picture picture = show(stage, settings);
            for (uint32_t i = 0; i < picture.pixels(); ++i) {
                const auto hit = stage(camera.position, camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight));
                if (!hit || hit->f0.x == 0) {
                    ASSERT_EQ(picture.weight[i * 4], 0);
                }
            }
        }
}

TEST_F(ScreenResolveTest, viewsAndDebugColoursFollowTheMapping) {
    Settings settings = plainSettings();
    const Picture whole = show(floorAndWall(), settings);
    settings.screen.resolutionScale = 0.5f;
    settings.debug.outcome = true;
    const Picture half = show(floorAndWall(), settings);
    size_t same = 0;
    for (size_t i = 0; i < whole.pixels(); ++i) {
        same += whole.outcome(i) == half.outcome(i);
        // Debug colours show what was clipped at the frustum as Babylon.js does, blue; the view shows it yellow.
        const bool clipped = half.outcome(i) == shared::kOutcomeOffScreen;
        if (half.outcome(i) != shared::kOutcomeNone) {
            ASSERT_NEAR(half.composite[i * 4], clipped ? 0 : half.outcomeColor[i * 4], 1e-3);
        }
        if (whole.hit(i) && half.hit(i)) {
            ASSERT_LT(glm::length(half.hitPX(i) - whole.hitPX(i)), 4) << i % kWidth << "," << i / kWidth;
        }
    }
    EXPECT_GT(same, whole.pixels() * 95 / 100);
}

TEST_F(ScreenResolveTest, tinyAndOddPicturesWorkAtEveryScale) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(17, 9), glm::uvec2(3, 57)})
        for (const float scale : {0.1f, 0.5f, 0.9f}) {
            Settings settings = plainSettings();
            settings.screen.resolutionScale = scale;
            settings.blur.strength = 0.2f;
            settings.blur.downsample = 3;
            const Picture picture = trace(floorAndWall(), SyntheticCamera{}, size.x, size.y, settings);
            for (const float value : picture.composite)
                ASSERT_TRUE(std::isfinite(value));
        }
}

TEST_F(ScreenResolveTest, scaleChangesBetweenFramesWithoutNewImages) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight);
    Settings settings = plainSettings();
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer));
    const Picture first = trace(made, camera.view(kWidth, kHeight));
    settings.screen.resolutionScale = 0.4f;
    must(made.setSettings(settings));
    const Picture small = trace(made, camera.view(kWidth, kHeight));
    EXPECT_LT(small.statistics.rays, first.statistics.rays / 4);
    settings.screen.resolutionScale = 1;
    must(made.setSettings(settings));
    EXPECT_EQ(trace(made, camera.view(kWidth, kHeight)).composite, first.composite);
}

// ---------------------------------------------------------------- blur

/// Number of floor pixels that show neither pure colour.
size_t mixed(const Picture& picture) {
    size_t count = 0;
    for (size_t i = 0; i < picture.pixels(); ++i)
        count += picture.reflection[i * 4] > 0.02f && picture.reflection[i * 4 + 1] > 0.02f;
    return count;
}

TEST_F(ScreenResolveTest, strengthWidensTheBlurOfRoughSurfaces) {
    Settings settings = plainSettings();
    const size_t none = mixed(show(twoColours(0.25f), settings));
    settings.blur.strength = 0.05f;
    const size_t little = mixed(show(twoColours(0.25f), settings));
    settings.blur.strength = 0.2f;
    const size_t much = mixed(show(twoColours(0.25f), settings));
    EXPECT_EQ(none, 0u);
    EXPECT_GT(little, 20u);
    EXPECT_GT(much, little * 2);
}

TEST_F(ScreenResolveTest, theBlurLeavesMirrorsAloneUnlessRoughFactorAsks) {
    Settings settings = plainSettings();
    const Picture sharp = show(twoColours(0), settings);
    settings.blur.strength = 0.2f;
    const Picture blurred = show(twoColours(0), settings);
    EXPECT_EQ(mixed(blurred), 0u);
    for (size_t i = 0; i < sharp.reflection.size(); ++i)
        ASSERT_NEAR(blurred.reflection[i], sharp.reflection[i], 0.001);
    settings.rough.factor = 0.3f;
    const Picture all = show(twoColours(0), settings);
    EXPECT_GT(mixed(all), 40u);
    EXPECT_EQ(all.hitUV, sharp.hitUV) << "with a blur the rays themselves are not jittered";
}

TEST_F(ScreenResolveTest, withoutABlurRoughFactorJittersRays) {
    Settings settings = plainSettings();
    const Picture mirror = show(twoColours(0.25f), settings);
    settings.rough.factor = 0.5f;
    EXPECT_NE(show(twoColours(0.25f), settings).hitUV, mirror.hitUV);
    settings.blur.strength = 0.1f;
    EXPECT_EQ(show(twoColours(0.25f), settings).hitUV, mirror.hitUV);
}

TEST_F(ScreenResolveTest, theBlurGrowsWithTheDistanceOfTheHit) {
    // Along the edge between the colours: near the wall's foot rays are short, towards the camera they are long.
    Settings settings = plainSettings();
    settings.blur.strength = 0.1f;
    const Picture picture = show(twoColours(0.25f), settings);
    std::vector<size_t> widths;
    for (uint32_t y = 0; y < kHeight; ++y) {
        size_t width = 0;
        size_t hits = 0;
        for (uint32_t x = 0; x < kWidth; ++x) {
            const size_t i = size_t(y) * kWidth + x;
            hits += picture.hit(i);
            width += picture.reflection[i * 4] > 0.02f && picture.reflection[i * 4 + 1] > 0.02f;
        }
        if (hits > kWidth / 2)
            widths.push_back(width);
    }
    ASSERT_GT(widths.size(), 10u);
    EXPECT_LE(widths[0], 3u) << "at the contact nothing is smeared";
    EXPECT_GT(widths.back(), widths[widths.size() / 4] + 2);
}

TEST_F(ScreenResolveTest, oneColourStaysThatColour) {
    // Where every hit shows one radiance, every answer is that radiance, whatever was mixed: misses reduce weight,
    // never colour. No black and no bright pixel at any edge.
    const glm::vec3 radiance(2, 1, 0.5f);
    for (const float scale : {1.0f, 0.6f})
        for (const int downsample : {0, 1, 3})
            for (const int quality : {1, 2, 3}) {
                Settings settings = plainSettings();
                settings.screen.resolutionScale = scale;
                settings.blur.strength = 0.3f;
                settings.blur.quality = quality;
                settings.blur.downsample = downsample;
                const Picture picture = show(uniformWall(0.2f, radiance), settings);
                size_t answers = 0;
                size_t partial = 0;
                for (size_t i = 0; i < picture.pixels(); ++i) {
                    const float weight = picture.weight[i * 4];
                    ASSERT_LE(weight, 1.001f);
                    if (weight < 0.05f)
                        continue;
                    ++answers;
                    partial += weight < 0.95f;
                    ASSERT_LT(glm::length(answered(picture, i) - radiance), 0.02f)
                        << "scale " << scale << ", downsample " << downsample << ", quality " << quality;
                }
                EXPECT_GT(answers, 200u);
                EXPECT_GT(partial, 40u) << "the wall's ends are soft";
            }
}

TEST_F(ScreenResolveTest, blurStopsAtSilhouettesAndCreases) {
    // A rough card stands on the floor before the wall; its own rays leave towards the camera and get no answer. If the
    // card's pixels bled into the floor behind it, that floor would lose weight.
    Settings settings = plainSettings();
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.2f;
    stage.cards.push_back({.low = {-0.25, 0}, .high = {0.25, 0.35}, .z = 0.5, .f0 = 1, .perceptualRoughness = 0.2f});
    const Picture sharp = show(stage, settings);
    settings.blur.strength = 0.3f;
    const Picture blurred = show(stage, settings);
    const SyntheticCamera camera;
    const auto onFloor = [&](uint32_t x, uint32_t y) {
        const auto hit = stage(camera.position, camera.rayThrough(x, y, kWidth, kHeight));
        return hit && hit->normalWS.y > 0.5 && hit->f0.x > 0;
    };
    size_t beside = 0;
    for (uint32_t y = 1; y + 1 < kHeight; ++y)
        for (uint32_t x = 1; x + 1 < kWidth; ++x) {
            if (!onFloor(x, y))
                continue;
            const bool edge = !onFloor(x - 1, y) || !onFloor(x + 1, y);
            bool allHit = true; // the floor around has full weight
            for (uint32_t v = y - 1; v <= y + 1; ++v)
                for (uint32_t u = x - std::min(x, 12u); u <= std::min(x + 12, kWidth - 1); ++u)
                    allHit = allHit && (!onFloor(u, v) || sharp.weight[(v * kWidth + u) * 4] > 0.99f);
            if (!edge || !allHit)
                continue;
            ++beside;
            ASSERT_GT(blurred.weight[(size_t(y) * kWidth + x) * 4], 0.9f) << x << "," << y;
        }
    EXPECT_GT(beside, 10u);
}

TEST_F(ScreenResolveTest, qualityAndDownsampleAct) {
    Settings settings = plainSettings();
    settings.blur.strength = 0.8f;
    settings.blur.quality = 1;
    const Picture few = show(twoColours(0.25f), settings);
    settings.blur.quality = 2;
    const Picture some = show(twoColours(0.25f), settings);
    settings.blur.quality = 3;
    const Picture many = show(twoColours(0.25f), settings);
    const auto difference = [](const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.reflection.size(); ++i)
            sum += std::abs(a.reflection[i] - b.reflection[i]);
        return sum;
    };
    EXPECT_GT(difference(few, many), difference(some, many));
    EXPECT_GT(difference(some, many), 0);
    settings.blur.downsample = 2;
    const Picture coarse = show(twoColours(0.25f), settings);
    EXPECT_GT(difference(coarse, many), 0);
    const auto upsamples = [](const Picture& picture) {
        return std::ranges::count(picture.passTimes, "resolve/upsample", &PassTime::name);
    };
    EXPECT_EQ(upsamples(many), 0);
    EXPECT_EQ(upsamples(coarse), 1);
}

TEST_F(ScreenResolveTest, noPassRunsWhereNoneIsAskedFor) {
    const Picture picture = show(floorAndWall(), plainSettings());
    for (const PassTime& pass : picture.passTimes)
        EXPECT_FALSE(pass.name.starts_with("resolve/") || pass.name.starts_with("denoise/")) << pass.name;
}

/// It reads and writes every pixel, those without a ray, too, and also where no view keeps the rays' answers. With
/// views the reflections are rounded to halves before they replace the host's, without them not.
TEST_F(ScreenResolveTest, itSeesEveryPixelWithoutViews) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), twoColours(0.25f), camera, kWidth, kHeight);
    const auto picture = [&](const Settings& settings, bool views) {
        Reflections made = must(Reflections::create(library(), {kWidth, kHeight, settings, false, views}));
        must(made.setInputs(host.gbuffer));
        HostImage image;
        run([&](VkCommandBuffer commands) { image = made.record(commands, camera.view(kWidth, kHeight)); });
        return download(gpu(), image);
    };
    Settings blurred = plainSettings();
    blurred.blur.strength = 0.3f;
    Settings coarse = blurred;
    coarse.blur.downsample = 1;
    Settings smaller = plainSettings();
    smaller.screen.resolutionScale = 0.5f;
    for (const Settings& settings : {blurred, coarse, smaller}) {
        const std::vector<float> shown = picture(settings, true);
        EXPECT_NE(shown, picture(plainSettings(), true));
        const std::vector<float> shipped = picture(settings, false);
        for (size_t i = 0; i < shown.size(); ++i)
            ASSERT_NEAR(shipped[i], shown[i], 4e-3 * std::max(shown[i], 1.0f)) << i / 4;
        Settings none = settings;
        none.reflect.threshold = 1; // no pixel sends a ray
        EXPECT_EQ(picture(none, false), picture(none, true));
    }
}

// ---------------------------------------------------------------- broken colours

TEST_F(ScreenResolveTest, brokenColoursDoNotSpread) {
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.2f;
    const auto broken = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = stage(origin, direction);
        if (hit && hit->f0.x == 0) {
            const int which = static_cast<int>(std::floor(hit->radiance.x * 8)) % 4;
            const float values[] = {NAN, INFINITY, -5, 0.5f};
            hit->radiance = glm::vec3(values[which]);
        }
        return hit;
    };
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), broken, camera, kWidth, kHeight);
    for (const float scale : {1.0f, 0.5f}) {
        Settings settings = plainSettings();
        settings.screen.resolutionScale = scale;
        settings.screen.colorSource = ColorSource::Previous;
        settings.blur.strength = 0.1f;
        Reflections made = reflections(kWidth, kHeight, settings);
        must(made.setInputs(host.gbuffer));
        Picture picture;
        for (int frame = 0; frame < 3; ++frame)
            picture = trace(made, camera.view(kWidth, kHeight));
        size_t lit = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            const auto hit = broken(camera.position, camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight));
            if (!hit || hit->f0.x == 0)
                continue; // the host's own pixels stay as they are
            for (uint32_t c = 0; c < 3; ++c) {
                const float value = picture.composite[i * 4 + c];
                ASSERT_TRUE(std::isfinite(value) && value >= 0 && value <= 65504.0f) << value;
            }
            lit += picture.composite[i * 4] > 0;
        }
        EXPECT_GT(lit, 500u);
    }
}

// ---------------------------------------------------------------- screen.targetFormat

TEST_F(ScreenResolveTest, eightBitsEndAtOneAndKeepTheHue) {
    Settings settings = plainSettings();
    const glm::vec3 radiance(3, 0.4f, 0.106f); // no half bytes once scaled to 1: devices may round those either way
    const Picture whole = show(uniformWall(0, radiance), settings);
    settings.screen.targetFormat = TargetFormat::Rgba16f;
    EXPECT_EQ(show(uniformWall(0, radiance), settings).composite, whole.composite) << "auto is rgba16f";
    settings.screen.targetFormat = TargetFormat::Rgba8;
    for (const float scale : {1.0f, 0.5f}) {
        settings.screen.resolutionScale = scale;
        const Picture eight = show(uniformWall(0, radiance), settings);
        size_t hits = 0;
        for (size_t i = 0; i < eight.pixels(); ++i) {
            if (eight.weight[i * 4] < 0.99f)
                continue;
            ++hits;
            ASSERT_NEAR(eight.reflection[i * 4], 1, 1e-3);
            ASSERT_NEAR(eight.reflection[i * 4 + 1], 34 / 255.0, scale < 1 ? 3e-3 : 1e-3);
            ASSERT_NEAR(eight.reflection[i * 4 + 2], 9 / 255.0, scale < 1 ? 3e-3 : 1e-3);
        }
        EXPECT_GT(hits, 100u);
    }
}

TEST_F(ScreenResolveTest, theFormatMayChangeBetweenFrames) {
    const SyntheticCamera camera;
    const SyntheticGBuffer host =
        SyntheticGBuffer::render(gpu(), uniformWall(0, glm::vec3(3)), camera, kWidth, kHeight);
    Settings settings = plainSettings();
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer));
    const View view = camera.view(kWidth, kHeight);
    const Picture first = trace(made, view);
    settings.screen.targetFormat = TargetFormat::Rgba8;
    must(made.setSettings(settings));
    EXPECT_NE(trace(made, view).composite, first.composite);
    settings.screen.enabled = false;
    settings.debug.outcome = true;
    must(made.setSettings(settings));
    const Picture off = trace(made, view);
    EXPECT_EQ(off.meanWeight(), 0);
    settings = plainSettings();
    must(made.setSettings(settings));
    EXPECT_EQ(trace(made, view).composite, first.composite);
}

} // namespace screen_resolve_test
} // namespace glint::test
