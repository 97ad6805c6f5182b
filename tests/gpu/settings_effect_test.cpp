// Every setting changes the image as documented, and by the formula where there is one. A setting's effect on a ray is
// measured on views: weight, hit position, lookups, outcome.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/trace/technique.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace settings_effect_test {

constexpr uint32_t kWidth = 121;
constexpr uint32_t kHeight = 67;

double smoothstep(double low, double high, double x) {
    const double t = glm::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

class SettingsEffectTest : public LibraryTest {
protected:
    static Picture show(const SyntheticScene& scene, const Settings& settings, const SyntheticCamera& camera = {}) {
        return trace(scene, camera, kWidth, kHeight, settings);
    }
    static Picture show(const Settings& settings) { return show(floorAndWall(), settings); }

    static uint64_t hits(const Picture& picture) { return picture.counted("hit"); }

    static glm::dvec3 startOf(uint32_t i, const SyntheticCamera& camera) {
        const glm::dvec3 d = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        return camera.position - d * (camera.position.y / d.y);
    }

    /// Number of iterations of each hit, from the fade by iterations; for settings with at most 1000 of them.
    static std::vector<uint32_t> iterations(Settings settings) {
        settings.fade.iterations = true;
        const double most = reflect::techniqueFor(settings.screen.march).maxSteps(settings);
        const Picture picture = show(settings);
        std::vector<uint32_t> counts;
        for (uint32_t i = 0; i < picture.pixels(); ++i)
            counts.push_back(static_cast<uint32_t>(std::lround((1 - picture.weight[i * 4]) * most)));
        return counts;
    }

    /// Weight at each hit against a formula of its UV, distance and pixel.
    template <class Weight>
    static void expectWeights(const Picture& picture, Weight weight, double tolerance) {
        uint64_t seenHits = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i))
                continue;
            ++seenHits;
            const glm::dvec2 uv(picture.hitUV[i * 4], picture.hitUV[i * 4 + 1]);
            ASSERT_NEAR(picture.weight[i * 4], weight(uv, i), tolerance) << "pixel " << i % kWidth << "," << i / kWidth;
        }
        ASSERT_GT(seenHits, 1000u);
    }
};

// A half's step below 1 is 2^-11; hit UVs are stored in steps of 2^-16.
constexpr double kWeightStep = 1.0 / 1024;

// ---------------------------------------------------------------- screen

TEST_F(SettingsEffectTest, enabled) {
    Settings settings = plainSettings();
    EXPECT_GT(hits(show(settings)), 1000u);
    settings.screen.enabled = false;
    EXPECT_EQ(show(settings).statistics.outcomes.size(), 0u);
}

TEST_F(SettingsEffectTest, maxDistanceEndsRays) {
    const SyntheticCamera camera;
    for (const float length : {1.0f, 3.0f}) {
        Settings settings = plainSettings();
        settings.screen.maxDistance = length;
        const Picture picture = show(settings);
        uint64_t near = 0;
        uint64_t far = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (picture.hit(i)) {
                ASSERT_LE(picture.hitDistance[i * 4], length * 1.001f);
                ++near;
            }
            far += picture.outcome(i) == shared::kOutcomeMaxDistance;
        }
        EXPECT_GT(near, 100u);
        EXPECT_GT(far, 300u);
    }
}

TEST_F(SettingsEffectTest, iterationsAreNeverExceededAndTheLastOneCounts) {
    // Each pixel's own number of iterations, as a limit for all: that pixel still hits, at its last sample.
    for (const March march : {March::Linear, March::Hiz}) {
        Settings settings = plainSettings(march);
        limitIterations(settings, 1000);
        const Picture enough = show(settings);
        const std::vector<uint32_t> needed = iterations(settings);
        uint64_t last = 0;
        for (const uint32_t limit : march == March::Linear ? std::array{14u, 25u, 38u} : std::array{1u, 3u, 6u}) {
            limitIterations(settings, static_cast<int>(limit));
            const Picture picture = show(settings);
            for (uint32_t i = 0; i < picture.pixels(); ++i) {
                ASSERT_LE(picture.lookups[i * 4],
                          static_cast<float>(reflect::techniqueFor(march).maxLookups(settings)));
                if (!enough.hit(i))
                    continue;
                ASSERT_EQ(picture.hit(i), needed[i] <= limit) << "needs " << needed[i] << " of " << limit;
                if (needed[i] > limit) {
                    ASSERT_EQ(picture.outcome(i), shared::kOutcomeOutOfSteps);
                } else {
                    ASSERT_EQ(picture.hitUV[i * 4 + 1], enough.hitUV[i * 4 + 1]);
                }
                last += needed[i] == limit;
            }
        }
        EXPECT_GT(last, 50u) << "hits on the last sample";
    }
}

TEST_F(SettingsEffectTest, hizMaxLevelIsTheLargestCellThatARayCrosses) {
    Settings settings = plainSettings();
    settings.hiz.maxIterations = 1000;
    const Picture coarse = show(settings);
    double before = 1e9;
    for (const int level : {0, 1, 2, 4}) {
        settings.hiz.maxLevel = level;
        const Picture picture = show(settings);
        const std::vector<uint32_t> counts = iterations(settings);
        const double cell = 1 << level;
        uint64_t seenHits = 0;
        uint64_t different = 0;
        double sum = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i))
                continue;
            different += !coarse.hit(i) || glm::length(picture.hitPX(i) - coarse.hitPX(i)) > 1;
            // Each iteration crosses one cell at most.
            const glm::dvec2 way = glm::abs(picture.hitPX(i) - glm::dvec2(i % kWidth + 0.5, i / kWidth + 0.5));
            ASSERT_GE(counts[i] + 1.0, std::max(way.x, way.y) / cell - 1) << "level " << level;
            sum += counts[i];
            ++seenHits;
        }
        EXPECT_EQ(different, 0u) << "level " << level;
        EXPECT_GT(seenHits, hits(coarse) * 19 / 20) << "level " << level;
        std::printf("hiz.maxLevel %d: %.1f iterations a hit, %zu of %zu hits\n", level,
                    sum / static_cast<double>(seenHits), size_t(seenHits), size_t(hits(coarse)));
        EXPECT_LT(sum, 0.8 * before) << "larger cells, fewer iterations";
        before = sum;
    }
}

TEST_F(SettingsEffectTest, adaptiveRefinementsAreSamplesInTheStepThatHits) {
    Settings settings = plainSettings(March::Adaptive);
    settings.adaptive.refinements = 0;
    const Picture none = show(settings);
    for (const int refinements : {1, 3, 5, 8}) {
        settings.adaptive.refinements = refinements;
        const Picture picture = show(settings);
        uint64_t both = 0;
        double more = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i) || !none.hit(i))
                continue;
            ++both;
            more += picture.lookups[i * 4] - none.lookups[i * 4];
        }
        ASSERT_GT(both, 500u) << refinements;
        std::printf("adaptive.refinements %d: %.2f more lookups a hit\n", refinements,
                    more / static_cast<double>(both));
        // Most rays go behind one surface alone.
        EXPECT_NEAR(more / static_cast<double>(both), refinements, 0.35 * refinements);
    }
}

/// A floor alone, whose rays end in the air: each takes one sample a step.
TEST_F(SettingsEffectTest, adaptiveStepsFollowTheLengthOnScreen) {
    const SyntheticCamera camera;
    constexpr float kLength = 1.5f; // metres
    for (const int steps : {4, 8, 40}) {
        Settings settings = plainSettings(March::Adaptive);
        settings.screen.maxDistance = kLength;
        settings.adaptive.steps = steps;
        settings.adaptive.pixelSpacing = 4;
        settings.adaptive.refinements = 0;
        const Picture picture = show(Stage(), settings, camera);
        uint64_t checked = 0;
        uint64_t between = 0; // of neither bound
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (picture.outcome(i) != shared::kOutcomeMaxDistance)
                continue;
            const glm::dvec3 start = startOf(i, camera);
            glm::dvec3 d = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            d.y = -d.y;
            const glm::dvec2 end = camera.project(start + d * double(kLength), kWidth, kHeight);
            if (glm::any(glm::lessThan(end, glm::dvec2(1))) ||
                glm::any(glm::greaterThan(end, glm::dvec2(kWidth - 1, kHeight - 1))))
                continue; // clipped at the border
            const glm::dvec2 way = glm::abs(end - camera.project(start, kWidth, kHeight));
            const double pixels = std::max(way.x, way.y);
            const auto expected = [&](double length) {
                return std::clamp(std::ceil(length / 4), double(steps), std::min(2.0 * steps, 128.0));
            };
            // Where rounding of the length cannot decide.
            if (expected(pixels - 0.02) != expected(pixels + 0.02))
                continue;
            ASSERT_EQ(picture.lookups[i * 4], expected(pixels)) << pixels << " pixels, base " << steps;
            ++checked;
            between += expected(pixels) != steps && expected(pixels) != 2 * steps;
        }
        EXPECT_GT(checked, 300u) << steps;
        EXPECT_TRUE(between > 100 || steps == 40) << between;
    }
}

/// A floor alone: whatever a ray hits there is its own surface.
TEST_F(SettingsEffectTest, halfDepthMakesNoFloorHitItself) {
    for (const reflect::Technique& technique : reflect::techniques())
        for (const double height : {0.1, 1.0, 4.0})
            for (const int skip : {0, 1, 2}) {
                SyntheticCamera camera;
                camera.position = {0, height, 3};
                camera.target = {0, height * 0.8, 0};
                Settings settings = plainSettings(technique.march);
                settings.gbuffer.depthFormat = DepthFormat::Half;
                settings.screen.selfCollisionSkip = skip;
                const Picture picture = show(Stage(), settings, camera);
                uint64_t selfHits = 0;
                for (uint32_t i = 0; i < picture.pixels(); ++i)
                    selfHits += picture.answered(i);
                EXPECT_GT(picture.statistics.rays, 3000u);
                EXPECT_EQ(selfHits, 0u) << technique.name << ", camera at " << height << " m, skip " << skip;
            }
}

TEST_F(SettingsEffectTest, stepSkipsPixels) {
    Settings settings = plainSettings(March::Linear);
    settings.screen.smooth = false;
    const double atOne = show(settings).statistics.lookupsMean;
    settings.screen.step = 8;
    const Picture coarse = show(settings);
    EXPECT_LT(coarse.statistics.lookupsMean, atOne / 2); // in open space neither takes samples: 6.9, 16.3
    EXPECT_GT(hits(coarse), 800u);
}

TEST_F(SettingsEffectTest, smoothFindsWhatCoarseStepsPass) {
    // A low card before the wall: a coarse step that goes behind both hits the wall, or nothing, unless the step is
    // refined.
    const SyntheticCamera camera;
    Stage stage = floorAndWall();
    stage.cards.push_back({.low = {-9, -9}, .high = {9, 0.2}, .z = -1.5});
    Settings settings = plainSettings(March::Linear);
    settings.screen.step = 16;
    settings.screen.smooth = false;
    const Picture rough = show(stage, settings);
    settings.screen.smooth = true;
    const Picture smooth = show(stage, settings);
    const auto rightOnes = [&](const Picture& picture) {
        uint64_t right = 0;
        uint64_t all = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.answered(i) || picture.hitDistance[i * 4] < 1e-3f)
                continue; // the floor's last row may start on the wall itself
            const glm::dvec3 start = startOf(i, camera);
            glm::dvec3 d = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            d.y = -d.y;
            const auto toCard = stage.cards[1].distance(start, d);
            const glm::dvec3 end = start + d * toCard.value_or((-3 - start.z) / d.z);
            ++all;
            right += picture.hit(i) && glm::length(picture.hitPX(i) - camera.project(end, kWidth, kHeight)) < 1;
        }
        return all ? static_cast<double>(right) / static_cast<double>(all) : 0;
    };
    EXPECT_GT(smooth.statistics.lookupsMean, rough.statistics.lookupsMean);
    settings.screen.step = 1;
    const Picture one = show(stage, settings);
    // Both miss a surface between two samples that are both in front of the depth buffer.
    EXPECT_GT(rightOnes(one), 0.99);
    EXPECT_GT(rightOnes(smooth), 0.9);
    EXPECT_LT(1 - rightOnes(smooth), (1 - rightOnes(rough)) / 2);
    settings.screen.smooth = false;
    EXPECT_EQ(one.hitUV, show(stage, settings).hitUV) << "acts only with step > 1";
}

/// A card before the wall; rays that pass behind it hit its side if it is assumed to be thick.
Stage withCard() {
    Stage stage = floorAndWall();
    stage.cards.push_back({.low = {-0.5, 0.25}, .high = {0.5, 0.9}, .z = 1});
    return stage;
}

/// Number of rays with this outcome on a card of `stage`.
uint64_t endedOn(const Picture& picture, const Stage& stage, size_t card, uint32_t outcome) {
    const SyntheticCamera camera;
    uint64_t count = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (picture.outcome(i) != outcome)
            continue;
        const glm::dvec2 px = glm::floor(picture.hitPX(i));
        const glm::dvec3 d =
            camera.rayThrough(static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y), kWidth, kHeight);
        count += stage.cards[card].distance(camera.position, d).has_value();
    }
    return count;
}

TEST_F(SettingsEffectTest, thicknessDecidesWhatPassesBehind) {
    const Stage stage = withCard();
    for (const reflect::Technique& technique : reflect::techniques()) {
        if (!technique.walks)
            continue; // surfaces have no thickness where no ray passes behind them
        SCOPED_TRACE(technique.name);
        Settings settings = plainSettings(technique.march);
        settings.hiz.depthBias = 0;
        settings.screen.thickness = 0;
        const Picture none = show(stage, settings);
        EXPECT_EQ(none.counted("side"), 0u) << "a surface without a slab has only a front";
        settings.screen.thickness = 0.01f;
        const uint64_t thin = endedOn(show(stage, settings), stage, 1, shared::kOutcomeSide);
        settings.screen.thickness = 1;
        const Picture thickPicture = show(stage, settings);
        const uint64_t thick = endedOn(thickPicture, stage, 1, shared::kOutcomeSide);
        EXPECT_LT(thin, 20u);
        EXPECT_GT(thick, thin + 50);
        EXPECT_EQ(endedOn(thickPicture, stage, 1, shared::kOutcomeHit), endedOn(none, stage, 1, shared::kOutcomeHit))
            << "fronts are met whatever the thickness";
        settings.screen.thicknessMode = ThicknessMode::Relative;
        settings.screen.thicknessRelative = 0;
        EXPECT_EQ(show(stage, settings).counted("side"), 0u) << "mode relative: the constant does not act";
    }
}

TEST_F(SettingsEffectTest, thicknessRelativeGrowsWithDistance) {
    const Stage stage = withCard();
    for (const reflect::Technique& technique : reflect::techniques()) {
        if (!technique.walks)
            continue; // surfaces have no thickness where no ray passes behind them
        SCOPED_TRACE(technique.name);
        Settings settings = plainSettings(technique.march);
        const auto sides = [&] {
            return static_cast<double>(endedOn(show(stage, settings), stage, 1, shared::kOutcomeSide));
        };
        settings.hiz.depthBias = 0;
        settings.screen.thicknessMode = ThicknessMode::Relative;
        settings.screen.thickness = 0;
        settings.screen.thicknessRelative = 0.005f;
        const double thin = sides();
        settings.screen.thicknessRelative = 0.5f; // of some 2 metres
        const double thick = sides();
        EXPECT_LT(thin, 20);
        EXPECT_GT(thick, thin + 50);
        // 0.5 of the card's viewZ equals that many metres: the same rays, except for the depth across the card.
        settings.screen.thicknessMode = ThicknessMode::Constant;
        settings.screen.thickness = 0.5f * 2.03f;
        EXPECT_NEAR(sides(), thick, thick * 0.1);
        settings.screen.thicknessRelative = 0;
        EXPECT_NEAR(sides(), thick, thick * 0.1) << "mode constant: the fraction does not act";
    }
}

TEST_F(SettingsEffectTest, hizDepthBiasIsASlabToo) {
    const Stage stage = withCard();
    Settings settings = plainSettings(March::Hiz);
    settings.screen.thicknessMode = ThicknessMode::Relative;
    settings.screen.thicknessRelative = 0.5f;
    settings.hiz.depthBias = 0;
    const Picture relative = show(stage, settings);
    settings.screen.thicknessRelative = 0;
    EXPECT_EQ(show(stage, settings).counted("side"), 0u);
    settings.hiz.depthBias = 0.5f;
    const Picture bias = show(stage, settings);
    EXPECT_GT(bias.counted("side"), 50u);
    EXPECT_EQ(bias.outcomeColor, relative.outcomeColor) << "a fraction of viewZ as well";
    EXPECT_EQ(bias.hitUV, relative.hitUV);
    settings.screen.march = March::Linear;
    EXPECT_EQ(show(stage, settings).counted("side"), 0u) << "the other marchers have none";
}

TEST_F(SettingsEffectTest, selfCollisionSkipLeavesOutTheFirstIterations) {
    for (const reflect::Technique& technique : reflect::techniques()) {
        if (!technique.walks)
            continue; // no iterations
        SCOPED_TRACE(technique.name);
        constexpr uint32_t kSkip = 3;
        Settings settings = plainSettings(technique.march);
        limitIterations(settings, 1000);
        settings.adaptive.steps = 16; // of some pixels each, so that the first steps hit
        settings.screen.selfCollisionSkip = 0;
        const Picture none = show(settings);
        const std::vector<uint32_t> without = iterations(settings);
        settings.screen.selfCollisionSkip = kSkip;
        const Picture some = show(settings);
        const std::vector<uint32_t> with = iterations(settings);
        uint64_t early = 0;
        for (uint32_t i = 0; i < none.pixels(); ++i) {
            if (some.answered(i)) {
                ASSERT_GT(with[i], kSkip) << i;
            }
            if (!none.hit(i))
                continue;
            early += without[i] <= kSkip;
            if (without[i] > kSkip) {
                ASSERT_EQ(with[i], without[i]) << i;
                ASSERT_EQ(some.hitUV[i * 4 + 1], none.hitUV[i * 4 + 1]) << i;
            } else if (technique.march != March::Hiz && some.answered(i)) {
                // A surface crossed in skipped iterations is hit at once by the first that counts, at the place of the
                // crossing.
                ASSERT_EQ(with[i], kSkip + 1) << i;
                ASSERT_TRUE(some.hit(i)) << i;
                ASSERT_NEAR(some.hitDistance[i * 4], none.hitDistance[i * 4], 0.01) << i;
            }
        }
        EXPECT_GT(early, 100u);
    }
}

TEST_F(SettingsEffectTest, clipToFrustumSavesNoHitAndChangesNone) {
    const auto inside = [](const Picture& picture, uint32_t i) { // in pixels from the border
        const glm::dvec2 px = picture.hitPX(i);
        return std::min(std::min(px.x, kWidth - px.x), std::min(px.y, kHeight - px.y));
    };
    for (const reflect::Technique& technique : reflect::techniques()) {
        if (!technique.walks)
            continue; // it samples only the end
        SCOPED_TRACE(technique.name);
        Settings settings = plainSettings(technique.march);
        limitIterations(settings, 1000);
        const Picture clipped = show(settings);
        settings.screen.clipToFrustum = false;
        const Picture whole = show(settings);
        uint64_t both = 0;
        for (uint32_t i = 0; i < clipped.pixels(); ++i) {
            if (clipped.hit(i) && whole.hit(i)) {
                ++both;
                ASSERT_LT(glm::length(clipped.hitPX(i) - whole.hitPX(i)), 1) << i;
            } else if (clipped.hitDistance[i * 4] + whole.hitDistance[i * 4] > 1e-3f) {
                ASSERT_LT(inside(clipped.hit(i) ? clipped : whole, i), 1) << i << ": only before the border";
            }
        }
        EXPECT_GT(both, 1000u);
    }
    // A ray of march linear that leaves is sampled up to the border's own pixels, not to the last whole step before; a
    // ray of march adaptive has all of its steps on screen.
    for (const March march : {March::Linear, March::Adaptive}) {
        Settings settings = plainSettings(march);
        const Picture clipped = show(settings);
        settings.screen.clipToFrustum = false;
        const Picture whole = show(settings);
        uint64_t more = 0;
        for (uint32_t i = 0; i < clipped.pixels(); ++i)
            if (clipped.outcome(i) == shared::kOutcomeOffScreen && whole.outcome(i) == shared::kOutcomeOffScreen)
                more += clipped.lookups[i * 4] > whole.lookups[i * 4];
        EXPECT_GT(more, 5u); // 30 of linear, 11 where quotients are products with the inverse
    }
}

// ---------------------------------------------------------------- reflect

TEST_F(SettingsEffectTest, thresholdHasTheHalfStepOfAnEightBitF0) {
    const auto traced = [](float f0, float threshold) {
        Stage stage = floorAndWall();
        stage.floorF0 = f0;
        Settings settings = plainSettings();
        settings.reflect.threshold = threshold;
        return show(stage, settings).statistics.rays > 0;
    };
    constexpr float kStep = 1.0f / 510;
    constexpr float kOneUnorm16 = 1.0f / 65535;
    EXPECT_FALSE(traced(0.04f, 0.04f));
    EXPECT_FALSE(traced(10 / 255.0f, 0.04f)) << "0.04 as 8 bits store it";
    EXPECT_FALSE(traced(0.04f + kStep - kOneUnorm16, 0.04f));
    EXPECT_TRUE(traced(0.04f + kStep + kOneUnorm16, 0.04f));
    EXPECT_FALSE(traced(kStep - kOneUnorm16, 0));
    EXPECT_TRUE(traced(1 / 255.0f, 0));
    EXPECT_TRUE(traced(0.04f, 0)) << "plain dielectrics reflect by default";
}

TEST_F(SettingsEffectTest, thresholdOnF0TimesStrength) {
    const auto traced = [](float f0, float strength, ThresholdOn on) {
        Stage stage = floorAndWall();
        stage.floorF0 = f0;
        Settings settings = plainSettings();
        settings.reflect.threshold = 0.05f;
        settings.reflect.thresholdOn = on;
        settings.reflect.strength = strength;
        return show(stage, settings).statistics.rays > 0;
    };
    EXPECT_TRUE(traced(0.1f, 0.5f, ThresholdOn::F0));
    EXPECT_FALSE(traced(0.1f, 0.5f, ThresholdOn::F0TimesStrength)) << "0.05 <= 0.05 + 1/510";
    EXPECT_TRUE(traced(0.11f, 0.5f, ThresholdOn::F0TimesStrength));
    EXPECT_FALSE(traced(0.04f, 2, ThresholdOn::F0));
    EXPECT_TRUE(traced(0.04f, 2, ThresholdOn::F0TimesStrength));
}

TEST_F(SettingsEffectTest, strengthExponentAndFresnelActOnTheComposite) {
    Stage stage = floorAndWall();
    stage.floorF0 = 0.5f;
    Settings settings = plainSettings();
    settings.reflect.fresnel = false;
    const Picture plain = show(stage, settings);
    const auto factor = [&](auto change) {
        Settings changed = settings;
        change(changed.reflect);
        const Picture picture = show(stage, changed);
        double sum = 0;
        double plainSum = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i)
            if (picture.hit(i)) { // the floor itself is black: all of its colour is reflection
                sum += picture.color(i).r;
                plainSum += plain.color(i).r;
            }
        return sum / plainSum;
    };
    EXPECT_NEAR(factor([](ReflectSettings&) {}), 1, 1e-9);
    EXPECT_NEAR(factor([](ReflectSettings& r) { r.strength = 0.5f; }), 0.5, 2e-3);
    EXPECT_NEAR(factor([](ReflectSettings& r) { r.falloffExponent = 2; }), 0.5, 2e-3);
    EXPECT_NEAR(factor([](ReflectSettings& r) { r.strength = 2, r.falloffExponent = 3; }), 2, 4e-3);
    EXPECT_GT(factor([](ReflectSettings& r) { r.fresnel = true; }), 1.05);
}

TEST_F(SettingsEffectTest, roughnessFadesBetweenItsTwoEnds) {
    Settings settings = plainSettings();
    settings.reflect.roughnessFadeStart = 0.2f;
    settings.reflect.maxRoughness = 0.5f;
    for (const float roughness : {0.1f, 0.2f, 0.3f, 0.45f}) {
        Stage stage = floorAndWall();
        stage.floorRoughness = roughness;
        expectWeights(
            show(stage, settings), [&](glm::dvec2, uint32_t) { return 1 - smoothstep(0.2, 0.5, roughness); },
            kWeightStep);
    }
    Stage stage = floorAndWall();
    stage.floorRoughness = 0.51f;
    EXPECT_EQ(show(stage, settings).statistics.rays, 0u);
    EXPECT_GT(show(stage, settings).counted("tooRough"), 1000u);
    // At or below the start: a hard edge just above it.
    settings.reflect.roughnessFadeStart = settings.reflect.maxRoughness = 0.5f;
    EXPECT_EQ(show(stage, settings).statistics.rays, 0u);
    stage.floorRoughness = 0.49f;
    expectWeights(
        show(stage, settings), [](glm::dvec2, uint32_t) { return 1; }, 0);
}

// ---------------------------------------------------------------- rough

TEST_F(SettingsEffectTest, roughFactorScattersRoughSurfacesOnly) {
    Settings settings = plainSettings();
    Stage smooth = floorAndWall();
    Stage rough = floorAndWall();
    rough.floorRoughness = 0.25f;
    const Picture mirror = show(smooth, settings);
    EXPECT_EQ(show(rough, settings).hitUV, mirror.hitUV) << "factor 0: mirror directions only";
    const auto scatter = [&](const Stage& stage, float factor) {
        settings.rough.factor = factor;
        const Picture picture = show(stage, settings);
        double sum = 0;
        uint64_t count = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i)
            if (picture.hit(i) && mirror.hit(i)) {
                sum += glm::length(picture.hitPX(i) - mirror.hitPX(i));
                ++count;
            }
        return sum / static_cast<double>(count);
    };
    EXPECT_LT(scatter(smooth, 1), 1e-3);
    const double little = scatter(rough, 0.2f);
    const double much = scatter(rough, 0.8f);
    EXPECT_GT(little, 0.1);
    EXPECT_GT(much, 2 * little);
}

TEST_F(SettingsEffectTest, noiseMovesWithFrameAndSeed) {
    Stage rough = floorAndWall();
    rough.floorRoughness = 0.25f;
    Settings settings = plainSettings();
    settings.rough.factor = 1;
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), rough, camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, settings);
    must(made.setInputs(host.gbuffer));
    const auto at = [&](uint32_t frame, uint32_t seed) {
        View view = camera.view(kWidth, kHeight);
        view.frameIndex = frame;
        view.seed = seed;
        return trace(made, view).hitUV;
    };
    const std::vector<float> first = at(0, 0);
    EXPECT_EQ(at(0, 0), first);
    EXPECT_NE(at(1, 0), first);
    EXPECT_NE(at(0, 1), first);
    EXPECT_NE(at(1, 0), at(0, 1));
}

// ---------------------------------------------------------------- fade

TEST_F(SettingsEffectTest, borderFadesByTheirFormulas) {
    Settings settings = plainSettings();
    settings.fade.border = FadeBorder::None_;
    expectWeights(
        show(settings), [](glm::dvec2, uint32_t) { return 1; }, 0);

    settings.fade.border = FadeBorder::Smooth;
    expectWeights(
        show(settings),
        [](glm::dvec2 uv, uint32_t) {
            const double x = smoothstep(0.2, 0.6, std::abs(0.5 - uv.x));
            const double y = smoothstep(0.2, 0.6, std::abs(0.5 - uv.y));
            return glm::clamp(1 - (x + y), 0.0, 1.0);
        },
        kWeightStep);

    for (const float width : {0.1f, 0.35f}) {
        settings.fade.border = FadeBorder::Linear;
        settings.fade.borderWidth = width;
        expectWeights(
            show(settings),
            [&](glm::dvec2 uv, uint32_t) {
                const double x = glm::clamp(std::min(uv.x, 1 - uv.x) / width, 0.0, 1.0);
                const double y = glm::clamp(std::min(uv.y, 1 - uv.y) / width, 0.0, 1.0);
                return x * y;
            },
            kWeightStep);
    }
    settings.fade.borderWidth = 0;
    expectWeights(
        show(settings), [](glm::dvec2, uint32_t) { return 1; }, 0);
}

TEST_F(SettingsEffectTest, distanceFadesToTheLongestRay) {
    Settings settings = plainSettings();
    settings.fade.distance = true;
    settings.screen.maxDistance = 8;
    const Picture picture = show(settings);
    expectWeights(
        picture, [&](glm::dvec2, uint32_t i) { return 1 - picture.hitDistance[i * 4] / 8; }, 2 * kWeightStep);
}

TEST_F(SettingsEffectTest, iterationsFadeToTheLastOne) {
    const SyntheticCamera camera;
    Settings settings = plainSettings(March::Linear);
    settings.fade.iterations = true;
    settings.screen.maxSteps = 90;
    const Picture linear = show(settings);
    // One iteration a pixel, up to the first behind the wall's plane, or the next where that is behind the pixel's
    // depth, or already that in whose pixel the ray goes behind the plane, half a pixel farther at most.
    expectWeights(
        linear,
        [&](glm::dvec2 uv, uint32_t i) {
            const glm::dvec2 way =
                glm::abs(uv * glm::dvec2(kWidth, kHeight) - glm::dvec2(i % kWidth + 0.5, i / kWidth + 0.5));
            return 1 - (std::max(way.x, way.y) + 1) / 90;
        },
        1.5 / 90 + kWeightStep);

    // For the other marchers, only that it is a whole number of iterations, no more than lookups, over the marcher's
    // own limit.
    for (const auto& [march, most] : {std::pair(March::Hiz, 60), std::pair(March::Adaptive, 128)}) {
        settings = plainSettings(march);
        settings.fade.iterations = true;
        limitIterations(settings, most);
        const Picture picture = show(settings);
        uint64_t hits = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i))
                continue;
            ++hits;
            const double count = (1 - picture.weight[i * 4]) * static_cast<double>(most);
            ASSERT_NEAR(count, std::round(count), kWeightStep * most);
            ASSERT_GE(std::round(count), 1);
            ASSERT_LE(std::round(count), picture.lookups[i * 4]);
        }
        EXPECT_GT(hits, 1000u);
    }
}

TEST_F(SettingsEffectTest, facingCameraFadesReturningRays) {
    // A steep view down at the floor: reflected rays partly return.
    SyntheticCamera camera;
    camera.position = {0, 1.5, 1.5};
    camera.target = {0, 0, 0};
    Stage stage;
    stage.cards.push_back({.low = {-9, 0}, .high = {9, 0.6}, .z = 0.2});
    Settings settings = plainSettings();
    settings.fade.facingCamera = true;
    const Picture picture = show(stage, settings, camera);
    uint64_t faded = 0;
    uint64_t leftOut = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const glm::dvec3 d = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto surface = stage(camera.position, d);
        if (!surface || surface->f0.x == 0)
            continue;
        const double VoR = glm::dot(-d, glm::reflect(d, surface->normalWS));
        const double expected = 1 - smoothstep(0.25, 0.5, VoR);
        if (VoR > 0.501) {
            ASSERT_EQ(picture.outcome(i), shared::kOutcomeFacingCamera);
            ++leftOut;
        } else if (picture.hit(i)) {
            ASSERT_NEAR(picture.weight[i * 4], expected, 2e-3);
            faded += expected < 0.95;
        }
    }
    EXPECT_GT(faded, 20u);
    EXPECT_GT(leftOut, 500u);
}

TEST_F(SettingsEffectTest, backfaceFadesHitsFromBehind) {
    // The wall's normals tilt so that rays hit it ever more edge-on, and a little from behind.
    const SyntheticCamera camera;
    const auto leaning = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (hit && hit->f0.x == 0) {
            const double angle = 1.45 + 0.1 * (origin + direction * hit->distance).x;
            hit->normalWS = {std::sin(angle), 0, std::cos(angle)}; // sideways: tilted up it could be the floor's own
        }
        return hit;
    };
    Settings settings = plainSettings();
    settings.fade.backface = true;
    const Picture picture = show(leaning, settings);
    uint64_t hitCount = 0;
    uint64_t faded = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.hit(i))
            continue;
        const glm::dvec2 inPixel = glm::fract(picture.hitPX(i));
        if (std::min(inPixel.x, inPixel.y) < 0.01 || std::max(inPixel.x, inPixel.y) > 0.99)
            continue; // which pixel's normal it has is rounding
        ++hitCount;
        const auto hit =
            leaning(camera.position, camera.rayThrough(static_cast<uint32_t>(picture.hitPX(i).x),
                                                       static_cast<uint32_t>(picture.hitPX(i).y), kWidth, kHeight));
        const glm::dvec3 toFloor = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const double NoR = glm::dot(hit->normalWS, -glm::dvec3(toFloor.x, -toFloor.y, toFloor.z));
        faded += NoR < -0.02;
        // The normal is stored in 16 bits, and the slope of the formula is at most 9.
        ASSERT_NEAR(picture.weight[i * 4], glm::smoothstep(-0.17, 0.0, NoR), kWeightStep + 9 * 2e-4);
    }
    EXPECT_GT(hitCount, 300u);
    EXPECT_GT(faded, 20u);
}

// ---------------------------------------------------------------- sky, composite, debug

TEST_F(SettingsEffectTest, skyFillsWhatTheScreenMissed) {
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(7, 0, 0); });
    const SyntheticCamera camera;
    Settings settings = plainSettings();
    const Picture with = trace(floorAndWall(), camera, kWidth, kHeight, settings, environment.map);
    settings.sky.enabled = false;
    const Picture without = trace(floorAndWall(), camera, kWidth, kHeight, settings, environment.map);
    uint64_t filled = 0;
    for (uint32_t i = 0; i < with.pixels(); ++i) {
        const bool missed = with.outcome(i) == shared::kOutcomeOffScreen;
        if (missed) {
            ASSERT_NEAR(with.color(i).r, 7, 0.01);
            ASSERT_EQ(without.color(i).r, 0);
            ++filled;
        } else if (with.hit(i)) {
            ASSERT_EQ(with.color(i), without.color(i));
        }
    }
    EXPECT_GT(filled, 30u);
}

TEST_F(SettingsEffectTest, compositeModelLerpDims) {
    // Half a mirror over a lit floor, no fallback: physical adds, lerp blends.
    const auto lit = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (hit && hit->f0.x > 0) {
            hit->f0 = glm::vec3(0.5f);
            hit->radiance = glm::vec3(4);
        } else if (hit) {
            hit->radiance = glm::vec3(2);
        }
        return hit;
    };
    Settings settings = plainSettings();
    settings.reflect.fresnel = false;
    const Picture physical = show(lit, settings);
    settings.composite.model = CompositeModel::Lerp;
    const Picture lerp = show(lit, settings);
    const SyntheticCamera camera;
    for (uint32_t i = 0; i < physical.pixels(); ++i) {
        if (!physical.hit(i))
            continue;
        ASSERT_NEAR(physical.color(i).r, 4 + 0.5 * 2, 0.01);
        const double NoV = -camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight).y;
        const double fresnel = 0.5 + 0.5 * std::pow(1 - NoV, 5);
        ASSERT_NEAR(lerp.color(i).r, 4 * 0.5 + 0.5 * 2 * fresnel, 0.01);
    }
}

TEST_F(SettingsEffectTest, debugOutcomeShowsHowRaysEnded) {
    Settings settings = plainSettings(March::Linear);
    settings.debug.outcome = true;
    settings.screen.maxSteps = 60;
    const Picture picture = show(settings);
    const SyntheticCamera camera;
    uint64_t green = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        const glm::vec3 color = picture.color(i);
        switch (picture.outcome(i)) {
        case shared::kOutcomeHit:
            ASSERT_EQ(color.r + color.b, 0);
            ASSERT_NEAR(color.g, std::max(picture.lookups[i * 4] / 60, 0.02f), 1e-3) << "brighter with more steps";
            ++green;
            break;
        case shared::kOutcomeOutOfSteps: ASSERT_EQ(color, glm::vec3(1, 0, 0)); break;
        case shared::kOutcomeOffScreen: ASSERT_EQ(color, glm::vec3(0, 0, 1)) << "clipped, as in Babylon.js"; break;
        case shared::kOutcomeMaxDistance: ASSERT_EQ(color, glm::vec3(0, 0, 1)); break;
        default: break;
        }
    }
    settings.screen.clipToFrustum = false;
    const Picture free = show(settings);
    for (uint32_t i = 0; i < free.pixels(); ++i)
        if (free.outcome(i) == shared::kOutcomeOffScreen) {
            ASSERT_EQ(free.color(i), glm::vec3(1, 1, 0));
        }
    EXPECT_GT(free.counted("offScreen"), 0u);
    settings.screen.clipToFrustum = true;
    EXPECT_GT(green, 1000u);
    EXPECT_GT(picture.counted("offScreen"), 0u);
    EXPECT_GT(picture.counted("outOfSteps"), 0u);

    settings.screen.march = March::Hiz;
    settings.hiz.maxIterations = 20; // brightness is relative to the marcher's own limit
    const Picture hiz = show(settings);
    for (uint32_t i = 0; i < hiz.pixels(); ++i)
        if (hiz.hit(i)) {
            ASSERT_NEAR(hiz.color(i).g, glm::clamp(hiz.lookups[i * 4] / 20, 0.02f, 1.0f), 1e-3);
        }
}

} // namespace settings_effect_test
} // namespace glint::test
