// The library's errors and their messages, and its behaviour when there is no work.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <cstring>

namespace glint::test {
namespace errors_test {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 27;

class ErrorsTest : public LibraryTest {
protected:
    static Error createError(uint32_t width, uint32_t height, const Settings& settings = {}) {
        const Result<Reflections> made = Reflections::create(library(), {width, height, settings, false, false});
        return made ? Error{ErrorCode::Io, "created"} : made.error();
    }
    static SyntheticGBuffer host(uint32_t width = kWidth, uint32_t height = kHeight) {
        return SyntheticGBuffer::render(gpu(), floorAndWall(), SyntheticCamera(), width, height);
    }
    static View view() { return SyntheticCamera().view(kWidth, kHeight); }
    static std::string inputsError(Reflections& reflections, const GBuffer& gbuffer,
                                   const EnvironmentMap& environment = {}) {
        const Result<void> result = reflections.setInputs(gbuffer, environment);
        return result ? "" : result.error().message;
    }
};

TEST_F(ErrorsTest, sizesOutOfRangeAreRefused) {
    for (const glm::uvec2 size :
         {glm::uvec2(0, 0), glm::uvec2(0, 8), glm::uvec2(8, 0), glm::uvec2(100000, 100000), glm::uvec2(16385, 8)}) {
        const Error error = createError(size.x, size.y);
        EXPECT_EQ(error.code, ErrorCode::InvalidArgument);
        EXPECT_THAT(error.message,
                    HasSubstr(std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels: each side must be 1"));
    }
}

TEST_F(ErrorsTest, settingsOutOfRangeAreNamedAndTheOldOnesStay) {
    Settings wrong;
    wrong.screen.maxDistance = -1;
    EXPECT_THAT(createError(8, 8, wrong).message, HasSubstr("screen.maxDistance"));
    wrong = {};
    wrong.fade.borderWidth = NAN;
    EXPECT_THAT(createError(8, 8, wrong).message, HasSubstr("fade.borderWidth"));

    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    const Picture before = trace(made, view());
    wrong = {};
    wrong.screen.enabled = false;
    wrong.screen.step = 65;
    const Result<void> refused = made.setSettings(wrong);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("screen.step"));
    EXPECT_EQ(trace(made, view()).composite, before.composite);
}

TEST_F(ErrorsTest, missingOrWrongImagesAreNamed) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer right = host();
    EXPECT_EQ(inputsError(made, right.gbuffer), "");
    const std::pair<const char*, HostImage GBuffer::*> images[] = {
        {"`depth`", &GBuffer::depth},
        {"`normal`", &GBuffer::normal},
        {"`material`", &GBuffer::material},
        {"`litRadiance`", &GBuffer::litRadiance},
    };
    for (const auto& [name, member] : images) {
        GBuffer missing = right.gbuffer;
        missing.*member = {};
        EXPECT_THAT(inputsError(made, missing), AllOf(HasSubstr(name), HasSubstr("missing")));
        GBuffer noView = right.gbuffer;
        (noView.*member).view = VK_NULL_HANDLE;
        EXPECT_THAT(inputsError(made, noView), AllOf(HasSubstr(name), HasSubstr("missing")));
        GBuffer small = right.gbuffer;
        (small.*member).width = 47;
        EXPECT_THAT(inputsError(made, small), AllOf(HasSubstr(name), HasSubstr("47x27"), HasSubstr("48x27")));
        GBuffer undefined = right.gbuffer;
        (undefined.*member).layout = VK_IMAGE_LAYOUT_UNDEFINED;
        EXPECT_THAT(inputsError(made, undefined), AllOf(HasSubstr(name), HasSubstr("layout")))
            << "such an image has no content, and cannot be given back as it was";
    }
    GBuffer fallback = right.gbuffer;
    fallback.fallbackSpecular = fallback.litRadiance;
    fallback.fallbackSpecular.height = 1;
    EXPECT_THAT(inputsError(made, fallback), HasSubstr("`fallbackSpecular`"));
    GBuffer channel = right.gbuffer;
    channel.roughness.channel = 4;
    EXPECT_THAT(inputsError(made, channel), HasSubstr("`roughness` is in channel 4"));
    channel = right.gbuffer;
    channel.metallic.channel = 4;
    EXPECT_THAT(inputsError(made, channel), HasSubstr("`metallic` is in channel 4"));
    GBuffer metallic = right.gbuffer;
    metallic.conventions.material = MaterialKind::MetallicRoughness;
    EXPECT_THAT(inputsError(made, metallic), AllOf(HasSubstr("`baseColor`"), HasSubstr("missing")));
}

TEST_F(ErrorsTest, sampleCountsMustAgree) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer right = host();
    for (HostImage GBuffer::*member : {&GBuffer::normal, &GBuffer::material, &GBuffer::litRadiance}) {
        GBuffer wrong = right.gbuffer;
        (wrong.*member).samples = 4;
        EXPECT_THAT(inputsError(made, wrong), HasSubstr("4 samples"));
    }
    for (const uint32_t samples : {0u, 3u, 32u}) {
        GBuffer wrong = right.gbuffer;
        wrong.depth.samples = wrong.normal.samples = wrong.material.samples = samples;
        EXPECT_THAT(inputsError(made, wrong), AllOf(HasSubstr("`depth`"), HasSubstr(std::to_string(samples))));
    }
}

TEST_F(ErrorsTest, brokenEnvironmentsAreRefused) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer right = host();
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    EXPECT_EQ(inputsError(made, right.gbuffer, environment.map), "");
    const auto refuses = [&](auto change) {
        EnvironmentMap map = environment.map;
        change(map);
        EXPECT_THAT(inputsError(made, right.gbuffer, map), HasSubstr("environment"));
    };
    refuses([](EnvironmentMap& map) { map.mips = 0; });
    refuses([](EnvironmentMap& map) { map.cube.view = VK_NULL_HANDLE; });
    refuses([](EnvironmentMap& map) { map.strength = NAN; });
    refuses([](EnvironmentMap& map) { map.strength = -1; });
    refuses([](EnvironmentMap& map) { map.rotation = INFINITY; });
    refuses([](EnvironmentMap& map) { map.cube.layout = VK_IMAGE_LAYOUT_UNDEFINED; });
}

TEST_F(ErrorsTest, unknownViewsAreNamedWithTheNearest) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    run([&](VkCommandBuffer commands) {
        made.record(commands, view());
        const Result<HostImage> wrong = made.recordView(commands, "hitUv2");
        ASSERT_FALSE(wrong);
        EXPECT_THAT(wrong.error().message, AllOf(HasSubstr("'hitUv2'"), HasSubstr("'hitUV'")));
    });
    Reflections without = must(Reflections::create(library(), {kWidth, kHeight, {}, false, false}));
    must(without.setInputs(gbuffer.gbuffer));
    run([&](VkCommandBuffer commands) {
        without.record(commands, view());
        const Result<HostImage> wrong = without.recordView(commands, "hitUV");
        ASSERT_FALSE(wrong);
        EXPECT_THAT(wrong.error().message, HasSubstr("ReflectionsDesc::views"));
    });
}

TEST_F(ErrorsTest, everyListedViewCanBeRecorded) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    run([&](VkCommandBuffer commands) {
        made.record(commands, view());
        for (const std::string_view name : Reflections::viewNames())
            EXPECT_TRUE(made.recordView(commands, name)) << name;
    });
}

TEST_F(ErrorsTest, nullHandlesAreNotAdopted) {
    const gpu::AdoptedDevice real = gpu().handles();
    const HostDevice right = {real.instance, real.physicalDevice, real.device, real.queueFamily,
                              real.getInstanceProcAddr};
    const auto refuses = [&](auto change, ErrorCode code) {
        HostDevice device = right;
        change(device);
        const Result<Context> adopted = Context::adopt(device);
        ASSERT_FALSE(adopted);
        EXPECT_EQ(adopted.error().code, code);
        EXPECT_FALSE(adopted.error().message.empty());
    };
    refuses([](HostDevice& device) { device.instance = VK_NULL_HANDLE; }, ErrorCode::InvalidArgument);
    refuses([](HostDevice& device) { device.physicalDevice = VK_NULL_HANDLE; }, ErrorCode::InvalidArgument);
    refuses([](HostDevice& device) { device.device = VK_NULL_HANDLE; }, ErrorCode::InvalidArgument);
    refuses([](HostDevice& device) { device.getInstanceProcAddr = nullptr; }, ErrorCode::InvalidArgument);
    refuses([](HostDevice& device) { device.queueFamily = 77; }, ErrorCode::InvalidArgument);
    EXPECT_TRUE(Context::adopt(right)) << "several contexts may stand on one device";
}

TEST_F(ErrorsTest, missingFallbackIsSaidOnce) {
    Reflections made = reflections(kWidth, kHeight);
    SyntheticGBuffer gbuffer = host();
    must(made.setInputs(gbuffer.gbuffer));
    must(made.setInputs(gbuffer.gbuffer));
    ASSERT_EQ(made.notes().size(), 1u);
    EXPECT_THAT(made.notes()[0], HasSubstr("fallbackSpecular"));
    gbuffer.gbuffer.fallbackSpecular = gbuffer.gbuffer.litRadiance;
    must(made.setInputs(gbuffer.gbuffer));
    EXPECT_TRUE(made.notes().empty());
}

// ---------------------------------------------------------------- nothing to do

TEST_F(ErrorsTest, withEverySourceOffThePictureIsTheHosts) {
    Settings off = plainSettings();
    off.screen.enabled = false;
    Reflections made = reflections(kWidth, kHeight, off);
    const SyntheticGBuffer gbuffer = host();
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    const auto recorded = [&] {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = made.record(commands, view()); });
        return image.image;
    };
    must(made.setInputs(gbuffer.gbuffer));
    EXPECT_EQ(recorded(), gbuffer.gbuffer.litRadiance.image) << "no environment: sky has nothing to say";
    EXPECT_TRUE(made.passTimes().empty());

    must(made.setInputs(gbuffer.gbuffer, environment.map));
    EXPECT_NE(recorded(), gbuffer.gbuffer.litRadiance.image);
    for (const PassTime& time : made.passTimes()) {
        EXPECT_THAT(time.name, testing::Not(HasSubstr("trace/")));
        EXPECT_GE(time.milliseconds, 0);
    }
    EXPECT_FALSE(made.passTimes().empty());

    off.sky.enabled = false;
    must(made.setSettings(off));
    EXPECT_EQ(recorded(), gbuffer.gbuffer.litRadiance.image);
    EXPECT_TRUE(made.passTimes().empty()) << "the newest frame had no pass";
    EXPECT_TRUE(made.statistics().outcomes.empty());
    for (const std::string_view name :
         {"reflection", "weight", "weights", "source", "outcome", "hitDistance", "lookups", "historyFrames"}) {
        const std::vector<float> values = readView(made, name);
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(values[i], i % 4 == 3 && name != "weights" ? 1.0f : 0.0f) << name; // alpha: opaque, or probes
    }
}

TEST_F(ErrorsTest, strengthZeroIsNoReflection) {
    Settings settings = plainSettings();
    settings.reflect.strength = 0;
    Reflections made = reflections(kWidth, kHeight, settings);
    SyntheticGBuffer gbuffer = host();
    gbuffer.gbuffer.fallbackSpecular = gbuffer.gbuffer.litRadiance;
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    must(made.setInputs(gbuffer.gbuffer, environment.map));
    HostImage image;
    run([&](VkCommandBuffer commands) { image = made.record(commands, view()); });
    EXPECT_EQ(image.image, gbuffer.gbuffer.litRadiance.image);
}

TEST_F(ErrorsTest, screenSwitchedOffLeavesNothingOfItsLastFrame) {
    Reflections made = reflections(kWidth, kHeight);
    const SyntheticGBuffer gbuffer = host();
    const TestEnvironment environment =
        TestEnvironment::make(gpu(), 4, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    must(made.setInputs(gbuffer.gbuffer, environment.map));
    EXPECT_GT(trace(made, view()).meanWeight(), 0.5);
    Settings off = plainSettings();
    off.screen.enabled = false;
    off.debug.outcome = true;
    must(made.setSettings(off));
    const Picture picture = trace(made, view());
    EXPECT_THAT(picture.lookups, Each(testing::AnyOf(0, 1))) << "0, and alpha";
    for (size_t i = 0; i < picture.pixels(); ++i) {
        ASSERT_EQ(picture.weight[i * 4], 0);
        ASSERT_EQ(picture.outcome(i), shared::kOutcomeNone);
    }
    must(made.setSettings(plainSettings()));
    EXPECT_GT(trace(made, view()).meanWeight(), 0.5) << "and back";
}

TEST_F(ErrorsTest, statisticsBeforeTheFirstFrameAreZero) {
    // Memory that was used before: the content of a fresh allocation is undefined.
    for (int round = 0; round < 3; ++round) {
        Reflections made = reflections(kWidth, kHeight);
        const Statistics statistics = made.statistics();
        EXPECT_EQ(statistics.rays, 0u);
        for (const Statistics::Outcome& outcome : statistics.outcomes)
            EXPECT_EQ(outcome.count, 0u) << outcome.name;
        const SyntheticGBuffer gbuffer = host();
        must(made.setInputs(gbuffer.gbuffer));
        trace(made, view());
    }
}

TEST_F(ErrorsTest, hostImagesComeBackInTheLayoutsTheyCameIn) {
    // The validation layer is active: a wrong layout on either side is a message.
    SyntheticGBuffer gbuffer = host();
    Reflections made = reflections(kWidth, kHeight);
    for (const VkImageLayout layout : {VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}) {
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            for (gpu::Image* image : {&gbuffer.depth, &gbuffer.normal, &gbuffer.material, &gbuffer.litRadiance})
                frame.hand(*image, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, layout});
        });
        for (HostImage* image :
             {&gbuffer.gbuffer.depth, &gbuffer.gbuffer.normal, &gbuffer.gbuffer.material, &gbuffer.gbuffer.litRadiance})
            image->layout = layout;
        must(made.setInputs(gbuffer.gbuffer));
        for (int frame = 0; frame < 2; ++frame)
            EXPECT_GT(trace(made, view()).meanWeight(), 0.5);
    }
}

TEST_F(ErrorsTest, depthStencilImagesAreTaken) {
    for (const VkFormat format : {VK_FORMAT_D32_SFLOAT, VK_FORMAT_D32_SFLOAT_S8_UINT, VK_FORMAT_D24_UNORM_S8_UINT}) {
        if (!gpu().supportsFormat(format, VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_2_TRANSFER_DST_BIT))
            continue;
        SyntheticGBuffer gbuffer = host();
        gpu::Image depth =
            must(gpu::Image::create(gpu(), {"test/depthStencil", format, kWidth, kHeight, 1, 1, gpu::ImageShape::Flat,
                                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                                VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}));
        const std::vector<float> values = must(gpu::downloadImageAsFloats(gpu(), gbuffer.depth));
        std::vector<uint32_t> texels; // the depth aspect alone: a float, or 24 bits
        for (size_t i = 0; i < values.size(); i += 4) {
            uint32_t bits = static_cast<uint32_t>(values[i] * 16777215.0f);
            if (format != VK_FORMAT_D24_UNORM_S8_UINT)
                std::memcpy(&bits, &values[i], 4);
            texels.push_back(bits);
        }
        gpu::Buffer staging = must(gpu::uploadBuffer(gpu(), "test/depth", texels, VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.copyFromBuffer(staging, 0, depth, 0, 0);
            frame.hand(depth, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                               VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL});
            frame.hand(gbuffer.depth, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                                       VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
        });
        Reflections made = reflections(kWidth, kHeight);
        must(made.setInputs(gbuffer.gbuffer));
        const Picture asFloat = trace(made, view());
        gbuffer.gbuffer.depth = asHostImage(depth);
        gbuffer.gbuffer.depth.layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
        must(made.setInputs(gbuffer.gbuffer));
        const Picture picture = trace(made, view());
        EXPECT_NEAR(picture.meanWeight(), asFloat.meanWeight(), 0.05) << format;
        size_t different = 0;
        for (size_t i = 0; i < picture.pixels(); ++i)
            different += picture.hit(i) != asFloat.hit(i);
        EXPECT_LT(different, picture.pixels() / 50) << format;
    }
}

} // namespace errors_test
} // namespace glint::test
