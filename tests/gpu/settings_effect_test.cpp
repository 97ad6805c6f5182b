// Every setting changes the picture as its meaning says, and by the formula where there is one. What a setting does to
// a ray is measured on views: weight, hit position, lookups, outcome.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace {

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

// A half's step below 1 is 2^-11; hit UVs come back in steps of 2^-16.
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

TEST_F(SettingsEffectTest, maxStepsAreNeverExceededAndTheLastOneCounts) {
    Settings settings = plainSettings();
    const Picture enough = show(settings);
    // Each pixel's own number of lookups, as a limit for all: that pixel still hits, at its last sample.
    uint64_t last = 0;
    for (const uint32_t limit : {14u, 25u, 38u}) {
        settings.screen.maxSteps = static_cast<int>(limit);
        const Picture picture = show(settings);
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            ASSERT_LE(picture.lookups[i * 4], static_cast<float>(limit));
            if (!enough.hit(i))
                continue;
            const auto needed = static_cast<uint32_t>(enough.lookups[i * 4]);
            ASSERT_EQ(picture.hit(i), needed <= limit) << "needs " << needed << " of " << limit;
            if (needed > limit) {
                ASSERT_EQ(picture.outcome(i), shared::kOutcomeOutOfSteps);
            }
            last += needed == limit;
        }
    }
    EXPECT_GT(last, 50u) << "hits on the last sample";
}

TEST_F(SettingsEffectTest, stepSkipsPixels) {
    Settings settings = plainSettings();
    settings.screen.smooth = false;
    const double atOne = show(settings).statistics.lookupsMean;
    settings.screen.step = 8;
    const Picture coarse = show(settings);
    EXPECT_LT(coarse.statistics.lookupsMean, atOne / 4);
    EXPECT_GT(hits(coarse), 800u);
}

TEST_F(SettingsEffectTest, smoothBringsCoarseHitsBackToTheirPixel) {
    // Coarse steps land up to 16 pixels behind the wall's line and must be brought back to it.
    const SyntheticCamera camera;
    Settings settings = plainSettings();
    settings.screen.step = 16;
    settings.screen.smooth = false;
    const Picture rough = show(settings);
    settings.screen.smooth = true;
    const Picture smooth = show(settings);
    const auto meanError = [&](const Picture& picture) {
        double sum = 0;
        uint64_t count = 0;
        for (uint32_t i = 0; i < picture.pixels(); ++i) {
            if (!picture.hit(i))
                continue;
            const glm::dvec3 start = startOf(i, camera);
            glm::dvec3 d = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            d.y = -d.y;
            const glm::dvec3 end = start + d * ((-3 - start.z) / d.z);
            sum += glm::length(picture.hitPX(i) - camera.project(end, kWidth, kHeight));
            ++count;
        }
        return count ? sum / static_cast<double>(count) : 1e9;
    };
    EXPECT_LT(meanError(smooth), 0.7);
    EXPECT_LT(meanError(smooth), meanError(rough) / 2);
    EXPECT_GT(smooth.statistics.lookupsMean, rough.statistics.lookupsMean);
    settings.screen.step = 1;
    const Picture one = show(settings);
    settings.screen.smooth = false;
    EXPECT_EQ(one.hitUV, show(settings).hitUV) << "acts only with step > 1";
}

/// A card before the wall; rays that pass behind it hit it if it is taken for thick.
Stage withCard() {
    Stage stage = floorAndWall();
    stage.cards.push_back({.low = {-0.5, 0.25}, .high = {0.5, 0.9}, .z = 1});
    return stage;
}

/// Hits on the card of z = 1, told by the blue-free position that it shows: y + 10 and x + 10.
uint64_t hitsAt(const Picture& picture, const Stage& stage, size_t card) {
    const SyntheticCamera camera;
    uint64_t count = 0;
    for (uint32_t i = 0; i < picture.pixels(); ++i) {
        if (!picture.hit(i))
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
    Settings settings = plainSettings();
    settings.screen.thickness = 0.01f;
    const uint64_t thin = hitsAt(show(stage, settings), stage, 1);
    settings.screen.thickness = 1;
    const uint64_t thick = hitsAt(show(stage, settings), stage, 1);
    EXPECT_LT(thin, 50u) << "the few that meet its front";
    EXPECT_GT(thick, thin + 50);
    settings.screen.thicknessMode = ThicknessMode::Relative;
    settings.screen.thicknessRelative = 0;
    EXPECT_EQ(hitsAt(show(stage, settings), stage, 1), thin) << "mode relative: the constant does not act";
}

TEST_F(SettingsEffectTest, thicknessRelativeGrowsWithDistance) {
    const Stage stage = withCard();
    Settings settings = plainSettings();
    settings.screen.thicknessMode = ThicknessMode::Relative;
    settings.screen.thickness = 0;
    settings.screen.thicknessRelative = 0.005f;
    const uint64_t thin = hitsAt(show(stage, settings), stage, 1);
    settings.screen.thicknessRelative = 0.5f; // of some 2 metres
    const uint64_t thick = hitsAt(show(stage, settings), stage, 1);
    EXPECT_LT(thin, 50u) << "the few that meet its front";
    EXPECT_GT(thick, thin + 50);
    // 0.5 of the card's viewZ is as much as that in metres: the same hits, but for the depth across the card.
    settings.screen.thicknessMode = ThicknessMode::Constant;
    settings.screen.thickness = 0.5f * 2.03f;
    EXPECT_NEAR(static_cast<double>(hitsAt(show(stage, settings), stage, 1)), static_cast<double>(thick),
                static_cast<double>(thick) * 0.1);
    settings.screen.thicknessRelative = 0;
    EXPECT_NEAR(static_cast<double>(hitsAt(show(stage, settings), stage, 1)), static_cast<double>(thick),
                static_cast<double>(thick) * 0.1)
        << "mode constant: the fraction does not act";
}

TEST_F(SettingsEffectTest, selfCollisionSkipLeavesOutTheFirstSamples) {
    Settings settings = plainSettings();
    settings.screen.selfCollisionSkip = 0;
    const Picture none = show(settings);
    settings.screen.selfCollisionSkip = 10;
    const Picture ten = show(settings);
    uint64_t early = 0;
    for (uint32_t i = 0; i < none.pixels(); ++i) {
        if (none.hit(i) && none.lookups[i * 4] <= 10) {
            ++early;
            ASSERT_FALSE(ten.hit(i) && ten.lookups[i * 4] <= 10);
        }
        if (none.hit(i) && none.lookups[i * 4] > 10) {
            ASSERT_EQ(ten.hitUV[i * 4 + 1], none.hitUV[i * 4 + 1]);
        }
    }
    EXPECT_GT(early, 100u);
}

TEST_F(SettingsEffectTest, clipToFrustumSavesNoHitAndChangesNone) {
    Settings settings = plainSettings();
    const Picture clipped = show(settings);
    settings.screen.clipToFrustum = false;
    const Picture whole = show(settings);
    uint64_t different = 0;
    for (uint32_t i = 0; i < clipped.pixels(); ++i)
        different += clipped.hit(i) != whole.hit(i);
    EXPECT_LE(different, 130u) << "but for the last half pixel before the border";
    // What it does: a ray that leaves is looked up to the border's own pixels, not to the last whole step before.
    uint64_t more = 0;
    for (uint32_t i = 0; i < clipped.pixels(); ++i)
        if (clipped.outcome(i) == shared::kOutcomeOffScreen && whole.outcome(i) == shared::kOutcomeOffScreen)
            more += clipped.lookups[i * 4] > whole.lookups[i * 4];
    EXPECT_GT(more, 30u);
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
    settings.fade.border = FadeBorder::None;
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

TEST_F(SettingsEffectTest, iterationsFadeToTheLastStep) {
    Settings settings = plainSettings();
    settings.fade.iterations = true;
    settings.screen.maxSteps = 90;
    const Picture picture = show(settings);
    expectWeights(
        picture, [&](glm::dvec2, uint32_t i) { return 1 - picture.lookups[i * 4] / 90; }, kWeightStep);
}

TEST_F(SettingsEffectTest, facingCameraFadesReturningRays) {
    // A steep look down at the floor: reflected rays come back part of the way.
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
    // The wall's normals lean so that rays meet it ever more edge-on, and a little from behind.
    const SyntheticCamera camera;
    const auto leaning = [](const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (hit && hit->f0.x == 0) {
            const double angle = 1.45 + 0.1 * (origin + direction * hit->distance).x;
            hit->normalWS = {std::sin(angle), 0, std::cos(angle)}; // sideways: leaning up it could be the floor's own
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
    Settings settings = plainSettings();
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
        case shared::kOutcomeOffScreen: ASSERT_EQ(color, glm::vec3(1, 1, 0)); break;
        case shared::kOutcomeMaxDistance: ASSERT_EQ(color, glm::vec3(0, 0, 1)); break;
        default: break;
        }
    }
    EXPECT_GT(green, 1000u);
    EXPECT_GT(picture.counted("offScreen"), 0u);
}

} // namespace
} // namespace glint::test
