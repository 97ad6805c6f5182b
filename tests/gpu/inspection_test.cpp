// Inspecting a pixel: its ray ends as the frame's own ray did, in every marcher and mode, and the frame does not
// change.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/inspect/inspector.hpp"
#include "reflect/trace/outcomes.hpp"
#include "reflect/trace/technique.hpp"
#include "shared/ray_log.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

namespace glint::test {
namespace inspection_test {

using testing::HasSubstr;

constexpr uint32_t kWidth = 96;
constexpr uint32_t kHeight = 54;

/// A mirror floor with objects on it, one of them rough, and a gap through which the background shows.
Stage stage() {
    Stage stage;
    stage.floorF0 = 0.9f;
    stage.floorRoughness = 0.1f;
    stage.cards.push_back({.low = {-9, 0}, .high = {1.2, 1.4}, .z = -3});
    stage.cards.push_back({.low = {-0.6, 0.1}, .high = {-0.1, 0.7}, .z = -1, .f0 = 0.5f});
    stage.cards.push_back({.low = {0.4, 0}, .high = {0.8, 0.5}, .z = -0.5, .f0 = 0.5f, .perceptualRoughness = 0.9f});
    return stage;
}

struct Mode {
    ThicknessMode thickness;
    float scale;
};

class InspectionTest : public LibraryTest {
protected:
    InspectionTest()
        : host_(SyntheticGBuffer::render(gpu(), stage(), camera_, kWidth, kHeight)),
          environment_(TestEnvironment::make(
              gpu(), 4, 2, [](const glm::dvec3& d, uint32_t) { return glm::vec3(d * 0.5 + 0.5) + 0.25f; })) {
        std::vector<float> depth;
        for (int i = 0; i < 40 * 20; ++i)
            depth.push_back(i % 5 == 0 ? 0.0f : static_cast<float>(camera_.deviceDepth(2.5 + i * 0.003)));
        back_ = uploadTestImage(gpu(), "test/backDepth", VK_FORMAT_R32_SFLOAT, 40, 20, bytesOf(depth));
        host_.gbuffer.backDepth = asHostImage(back_);
    }

    Reflections make(const Settings& settings) {
        Reflections made = must(Reflections::create(library(), {kWidth, kHeight, settings, true, true, true}));
        must(made.setInputs(host_.gbuffer, environment_.map));
        return made;
    }

    View view(uint32_t frame = 0) const {
        View view = camera_.view(kWidth, kHeight);
        view.frameIndex = frame;
        return view;
    }

    static RayInspection inspect(Reflections& made, uint32_t x, uint32_t y) {
        run([&](VkCommandBuffer commands) { must(made.recordInspection(commands, x, y)); });
        return made.inspection();
    }

    static std::vector<float> show(Reflections& made, const char* name) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = must(made.recordView(commands, name)); });
        return download(gpu(), image);
    }

    SyntheticCamera camera_;
    SyntheticGBuffer host_;
    gpu::Image back_;
    TestEnvironment environment_;
};

/// All that the frame records about its pixels.
struct Frame {
    std::vector<float> ray, color, weight, reflection, weights;
    bool operator==(const Frame&) const = default;
};

float sampled(const std::vector<float>& picture, uint32_t x, uint32_t y, uint32_t channel) {
    return picture[(size_t{y} * kWidth + x) * 4 + channel];
}

/// Halves have eleven bits.
constexpr float kHalf = 1.0f / 1024;

class MarchInspectionTest : public InspectionTest, public testing::WithParamInterface<size_t> {
protected:
    static const reflect::Technique& technique() { return reflect::techniques()[GetParam()]; }

    /// With the volume that fits the wall at z = -3, for march proxy.
    Reflections makeWithin(Settings settings) {
        settings.probes.enabled = false;
        Reflections made = make(settings);
        volumes_.push_back(TestVolumes::giveTo(made, gpu(), library(), {wallVolume()}));
        return made;
    }

    std::vector<TestVolumes> volumes_;

    static Settings settings(const Mode& mode) {
        Settings settings = plainSettings();
        settings.screen.march = technique().march;
        settings.screen.thicknessMode = mode.thickness;
        settings.screen.thicknessRelative = 0.02f;
        settings.screen.resolutionScale = mode.scale;
        settings.rough.factor = 0.1f; // rays of this frame only
        settings.fade.border = FadeBorder::Linear;
        settings.fade.distance = true;
        settings.screen.maxDistance = 20;
        settings.screen.step = 2;
        return settings;
    }

    static Frame frameOf(Reflections& made) {
        return {show(made, "ray"), show(made, "color"), show(made, "weight"), show(made, "reflection"),
                show(made, "weights")};
    }

    /// Against the frame's record of the same pixel.
    static void expectSameRay(const RayInspection& found, const Frame& frame, uint32_t x, uint32_t y) {
        const auto outcome = static_cast<uint32_t>(sampled(frame.ray, x, y, 2));
        ASSERT_EQ(found.outcome, reflect::kOutcomeNames[outcome]);
        ASSERT_EQ(found.traced, reflect::isTraced(outcome)) << found.whyNoRay;
        EXPECT_EQ(found.hit, outcome == shared::kOutcomeHit);
        EXPECT_EQ(found.answered, reflect::isAnswered(outcome));
        if (!found.traced) {
            EXPECT_TRUE(found.samples.empty());
            EXPECT_FALSE(found.whyNoRay.empty());
            return;
        }
        EXPECT_TRUE(found.sameAsFrame);
        EXPECT_EQ(found.lookups, static_cast<uint32_t>(sampled(frame.ray, x, y, 3)));
        const float halfStep = 0.51f / 65535; // of the record's position
        EXPECT_NEAR(std::clamp(found.end.px[0] / kWidth, 0.0f, 1.0f), sampled(frame.ray, x, y, 0), halfStep);
        EXPECT_NEAR(std::clamp(found.end.px[1] / kHeight, 0.0f, 1.0f), sampled(frame.ray, x, y, 1), halfStep);
    }

    /// The log must be consistent with itself.
    static void expectWhole(const RayInspection& found, ThicknessMode mode) {
        size_t backLookups = 0;
        for (const RaySample& sample : found.samples) {
            EXPECT_GE(sample.distance, 0);
            if (sample.level == 0 && mode == ThicknessMode::Backface)
                backLookups += sample.slabEndDepth.has_value();
            if (sample.decision == "front" && sample.level == 0) {
                EXPECT_LT(sample.rayDepth, sample.sceneDepth);
            }
        }
        EXPECT_GE(found.lookups, found.samples.size() + backLookups);
        EXPECT_LE(found.lookups, found.samples.size() + 2 * backLookups) << "a slab is asked for twice at most";
        EXPECT_FALSE(found.truncated);
        EXPECT_NEAR(found.start.depth, -found.start.positionVS[2], 1e-4f * found.start.depth);
        EXPECT_NEAR(found.end.depth, -found.end.positionVS[2], 1e-2f * found.end.depth);
        const glm::vec3 start(found.start.positionWS[0], found.start.positionWS[1], found.start.positionWS[2]);
        const glm::vec3 end(found.end.positionWS[0], found.end.positionWS[1], found.end.positionWS[2]);
        EXPECT_NEAR(glm::distance(start, end), found.length, 1e-3f * found.length + 1e-4f);
        if (!found.answered)
            return;
        float product = 1;
        for (const RayInspection::Fade& fade : found.fades)
            product *= fade.factor;
        EXPECT_NEAR(found.weight, product, 1e-5f);
        EXPECT_EQ(found.fades.size(), 3u) << "roughness, border and distance act";
        EXPECT_EQ((*found.hitPixel)[0], static_cast<uint32_t>(found.end.px[0]));
        EXPECT_EQ((*found.hitPixel)[1], static_cast<uint32_t>(found.end.px[1]));
    }
};

TEST_P(MarchInspectionTest, EveryRayEndsAsTheFrameSays) {
    std::set<std::string_view> outcomes;
    for (const ThicknessMode thickness : {ThicknessMode::Constant, ThicknessMode::Relative, ThicknessMode::Backface})
        for (const float scale : {1.0f, 0.6f}) {
            const Mode mode = {thickness, scale};
            SCOPED_TRACE(testing::Message() << "thickness mode " << static_cast<int>(thickness) << ", scale " << scale);
            Reflections made = makeWithin(settings(mode));
            run([&](VkCommandBuffer commands) { made.record(commands, view(3)); });
            const Frame frame = frameOf(made);
            for (uint32_t y = 1; y < kHeight; y += 5)
                for (uint32_t x = 2; x < kWidth; x += 7) {
                    SCOPED_TRACE(testing::Message() << "pixel " << x << "," << y);
                    const RayInspection found = inspect(made, x, y);
                    ASSERT_NO_FATAL_FAILURE(expectSameRay(found, frame, x, y));
                    outcomes.insert(found.outcome);
                    if (!found.traced)
                        continue;
                    expectWhole(found, thickness);
                    if (scale == 1) {
                        EXPECT_EQ(found.rayPixel, found.pixel);
                        EXPECT_NEAR(found.weight, sampled(frame.weight, x, y, 0), kHalf);
                        for (uint32_t c = 0; c < 3 && found.weight > 0; ++c)
                            EXPECT_NEAR(found.radiance[c], sampled(frame.color, x, y, c), kHalf * found.radiance[c]);
                    }
                }
            EXPECT_TRUE(frame == frameOf(made)) << "inspecting left other bits";
        }
    for (const char* outcome : {"hit", "offScreen", "none", "belowThreshold", "tooRough"})
        EXPECT_TRUE(outcomes.contains(outcome)) << outcome;
}

TEST_P(MarchInspectionTest, AHitIsTheLastThatWasDecided) {
    Reflections made = makeWithin(settings({ThicknessMode::Constant, 1}));
    run([&](VkCommandBuffer commands) { made.record(commands, view()); });
    size_t answers = 0;
    for (uint32_t y = 1; y < kHeight; y += 4)
        for (uint32_t x = 2; x < kWidth; x += 5) {
            const RayInspection found = inspect(made, x, y);
            if (!found.answered)
                continue;
            ++answers;
            const bool decided = std::any_of(found.samples.begin(), found.samples.end(),
                                             [&](const RaySample& sample) { return sample.decision == found.outcome; });
            EXPECT_TRUE(decided) << x << "," << y << ": " << found.outcome;
        }
    EXPECT_GT(answers, 30u);
}

TEST_P(MarchInspectionTest, FollowsTheLastFramesColours) {
    Settings previous = settings({ThicknessMode::Relative, 1});
    previous.screen.colorSource = ColorSource::Previous;
    Reflections made = makeWithin(previous);
    for (uint32_t frame = 0; frame < 3; ++frame)
        run([&](VkCommandBuffer commands) { made.record(commands, view(frame)); });
    const Frame frame = frameOf(made);
    for (uint32_t y = 2; y < kHeight; y += 9)
        for (uint32_t x = 3; x < kWidth; x += 11) {
            const RayInspection found = inspect(made, x, y);
            ASSERT_NO_FATAL_FAILURE(expectSameRay(found, frame, x, y));
            for (uint32_t c = 0; c < 3 && found.weight > 0; ++c)
                EXPECT_NEAR(found.radiance[c], sampled(frame.color, x, y, c), kHalf * found.radiance[c]);
        }
    EXPECT_TRUE(frame == frameOf(made));
}

INSTANTIATE_TEST_SUITE_P(Registry, MarchInspectionTest, testing::Range<size_t>(0, reflect::techniques().size()),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });

TEST_F(InspectionTest, SourcesAddUpToTheReflection) {
    Settings settings = plainSettings();
    settings.fade.border = FadeBorder::Linear;
    settings.fade.borderWidth = 0.4f;
    settings.blur.strength = 0.03f; // sources are asked after it
    Reflections made = make(settings);
    HostImage composite;
    run([&](VkCommandBuffer commands) { composite = made.record(commands, view()); });
    const std::vector<float> picture = download(gpu(), composite);
    const std::vector<float> reflection = show(made, "reflection");
    size_t both = 0;
    for (uint32_t y = 1; y < kHeight; y += 5)
        for (uint32_t x = 2; x < kWidth; x += 7) {
            const RayInspection found = inspect(made, x, y);
            glm::vec3 sum(0);
            float total = 0;
            for (const RayInspection::Source& source : found.sources) {
                sum += source.weight * glm::vec3(source.radiance[0], source.radiance[1], source.radiance[2]);
                total += source.weight;
            }
            both += found.sources.size() == 2;
            EXPECT_NEAR(total, found.totalWeight, kHalf);
            for (uint32_t c = 0; c < 3; ++c) {
                const auto axis = static_cast<glm::length_t>(c);
                EXPECT_NEAR(sum[axis], found.reflected[c], kHalf * sum[axis]);
                EXPECT_EQ(found.reflected[c], sampled(reflection, x, y, c));
                EXPECT_EQ(found.composite[c], sampled(picture, x, y, c));
            }
        }
    EXPECT_GT(both, 10u);
}

TEST_F(InspectionTest, APixelWithoutARaySaysWhy) {
    Reflections made = make(plainSettings());
    run([&](VkCommandBuffer commands) { made.record(commands, view()); });
    const auto at = [&](const glm::dvec3& position) {
        const glm::dvec2 px = camera_.project(position, kWidth, kHeight);
        return inspect(made, static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y));
    };
    const RayInspection background = inspect(made, kWidth - 1, 0);
    EXPECT_TRUE(background.background);
    EXPECT_THAT(std::string(background.whyNoRay), HasSubstr("no surface"));
    EXPECT_TRUE(background.sources.empty());
    const RayInspection dull = at({-1, 0.5, -3});
    EXPECT_EQ(dull.outcome, "belowThreshold");
    EXPECT_THAT(std::string(dull.whyNoRay), HasSubstr("reflect.threshold"));
    const RayInspection rough = at({0.6, 0.3, -0.5});
    EXPECT_EQ(rough.outcome, "tooRough");
    EXPECT_NEAR(rough.perceptualRoughness, 0.9f, 1e-3f);
    EXPECT_NEAR(rough.f0[0], 0.5f, 1e-3f);
    ASSERT_EQ(rough.sources.size(), 1u);
    EXPECT_EQ(rough.sources[0].name, "sky");
    const RayInspection floor = at({0, 0, 0.5});
    EXPECT_TRUE(floor.traced);
    EXPECT_NEAR(floor.normalWS[1], 1, 1e-3f);
    EXPECT_NEAR(floor.positionWS[1], 0, 1e-2f);
}

TEST_F(InspectionTest, WithoutTheScreenSourceNothingIsTraced) {
    Settings settings = plainSettings();
    settings.screen.enabled = false;
    for (const bool sky : {true, false}) { // false: no pass ran at all
        settings.sky.enabled = sky;
        Reflections made = make(settings);
        HostImage composite;
        run([&](VkCommandBuffer commands) { composite = made.record(commands, view()); });
        const std::vector<float> picture = download(gpu(), composite);
        const RayInspection found = inspect(made, kWidth / 2, kHeight - 4);
        EXPECT_FALSE(found.traced);
        EXPECT_THAT(std::string(found.whyNoRay), HasSubstr("screen.enabled"));
        EXPECT_EQ(found.sources.size(), sky ? 1u : 0u);
        EXPECT_EQ(found.composite[1], sampled(picture, kWidth / 2, kHeight - 4, 1));
    }
}

TEST_F(InspectionTest, MayShareTheFramesCommands) {
    Reflections made = make(plainSettings());
    run([&](VkCommandBuffer commands) {
        made.record(commands, view());
        must(made.recordInspection(commands, 1, 1));
        must(made.recordInspection(commands, kWidth / 2, kHeight - 4));
    });
    const RayInspection found = made.inspection();
    EXPECT_EQ(found.pixel, (std::array<uint32_t, 2>{kWidth / 2, kHeight - 4}));
    EXPECT_TRUE(found.traced && found.sameAsFrame);
}

TEST_F(InspectionTest, HostImagesKeepTheirLayouts) {
    // The validation layer is active.
    run([&](VkCommandBuffer commands) {
        gpu::Frame frame(gpu(), commands);
        for (gpu::Image* image : {&host_.material, &host_.litRadiance})
            frame.hand(*image,
                       {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, VK_IMAGE_LAYOUT_GENERAL});
    });
    host_.gbuffer.material.layout = host_.gbuffer.litRadiance.layout = VK_IMAGE_LAYOUT_GENERAL;
    Reflections made = make(plainSettings());
    for (uint32_t frame = 0; frame < 2; ++frame) {
        run([&](VkCommandBuffer commands) { made.record(commands, view(frame)); });
        show(made, "reflectivity");
        EXPECT_TRUE(inspect(made, kWidth / 2, kHeight - 4).sameAsFrame);
    }
}

TEST_F(InspectionTest, SaysWhatIsMissing) {
    const auto message = [&](Reflections& made, uint32_t x, uint32_t y) {
        Result<void> recorded;
        run([&](VkCommandBuffer commands) { recorded = made.recordInspection(commands, x, y); });
        return recorded ? std::string() : recorded.error().message;
    };
    Reflections without = reflections(kWidth, kHeight);
    EXPECT_THAT(message(without, 0, 0), HasSubstr("ReflectionsDesc::inspection"));
    Reflections made = make(plainSettings());
    EXPECT_THAT(message(made, 0, 0), HasSubstr("nothing was recorded"));
    run([&](VkCommandBuffer commands) { made.record(commands, view()); });
    EXPECT_EQ(message(made, kWidth - 1, kHeight - 1), "");
    EXPECT_THAT(message(made, kWidth, 0), HasSubstr("pixel 96,0 lies outside the picture of 96x54"));
    EXPECT_THAT(message(made, 0, kHeight), HasSubstr("pixel 0,54"));
    must(made.setSettings(plainSettings()));
    EXPECT_THAT(message(made, 0, 0), HasSubstr("nothing was recorded"));
}

TEST_F(InspectionTest, MoreSamplesThanThereIsRoomForAreCut) {
    std::vector<std::byte> log(reflect::kRayLogSize);
    shared::RayLogHeader header = {};
    header.ray.traced = 1;
    header.sampleCount = kMaxRaySamples + 1;
    std::memcpy(log.data(), &header, sizeof(header));
    const RayInspection found = reflect::readRayLog(log.data(), true, {});
    EXPECT_EQ(found.samples.size(), kMaxRaySamples);
    EXPECT_TRUE(found.truncated);
}

TEST_F(InspectionTest, ViewsTellHitsFromSidesAndMisses) {
    Reflections made = make(plainSettings());
    run([&](VkCommandBuffer commands) { made.record(commands, view()); });
    const std::vector<float> ray = show(made, "ray");
    const std::vector<float> success = show(made, "hitSuccess");
    const std::vector<float> hitDepth = show(made, "hitDepth");
    const std::vector<float> depth = show(made, "depth");
    const std::vector<float> color = show(made, "color");
    std::map<uint32_t, glm::vec3> colors;
    for (size_t i = 0; i < ray.size(); i += 4) {
        const auto outcome = static_cast<uint32_t>(ray[i + 2]);
        colors[outcome] = {success[i], success[i + 1], success[i + 2]};
        const bool answered = reflect::isAnswered(outcome);
        const auto x = static_cast<size_t>(ray[i] * kWidth);
        const auto y = static_cast<size_t>(ray[i + 1] * kHeight);
        EXPECT_EQ(hitDepth[i], answered ? depth[(y * kWidth + x) * 4] : 0);
        if (!answered) {
            EXPECT_EQ(color[i], 0);
        }
    }
    const glm::vec3 hit = colors.at(shared::kOutcomeHit);
    EXPECT_TRUE(hit.g > hit.r && hit.g > hit.b) << "light green";
    const glm::vec3 miss = colors.at(shared::kOutcomeOffScreen);
    EXPECT_TRUE(miss.b > miss.g && miss.g > miss.r) << "light blue";
    EXPECT_EQ(colors.at(shared::kOutcomeNone), glm::vec3(0));
    EXPECT_EQ(colors.at(shared::kOutcomeBelowThreshold), glm::vec3(0));
}

} // namespace inspection_test
} // namespace glint::test
