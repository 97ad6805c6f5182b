// Cost of Reflections::record for the calling thread: no allocation, no waiting.
#include "c_api/struct_reading.hpp"
#include "gpu/support/allocations.hpp"
#include "gpu/support/frames_in_flight.hpp"
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"
#include "gpu/support/thread_time.hpp"

#include <algorithm>
#include <chrono>
#include <deque>

namespace glint::test {
namespace record_cost_test {

double wallMilliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

/// Uses a device of its own without the validation layer, whose work would be counted as ours.
class RecordCostTest : public testing::Test {
protected:
    void SetUp() override {
        context_ = must(gpu::Context::create({}));
        context_->addShaders(gpu::shaders::reflect());
        const gpu::AdoptedDevice handles = context_->handles();
        library_.emplace(must(Context::adopt({handles.instance, handles.physicalDevice, handles.device,
                                              handles.queueFamily, handles.getInstanceProcAddr, handles.rayQuery})));
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.3f));
        scene_.addQuad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, emitting({1, 0.5f, 0.25f}));
        environment_ = TestEnvironment::make(*context_, 8, 1, [](const auto&, uint32_t) { return glm::vec3(0.5f); });
    }

    /// Every feature that a frame may have is enabled.
    static Settings everything() {
        Settings settings;
        settings.screen.colorSource = ColorSource::Previous;
        settings.screen.resolutionScale = 0.5f;
        settings.blur.strength = 0.5f;
        settings.rays.enabled = true;
        settings.rays.accumulate = true;
        settings.probes.enabled = true;
        settings.planar.enabled = true;
        return settings;
    }

    std::unique_ptr<gpu::Context> context_;
    std::optional<Context> library_;
    SurfaceScene scene_;
    TestEnvironment environment_;
    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
};

TEST_F(RecordCostTest, AllocatesNothing) {
    if (!countsAllocations())
        GTEST_SKIP() << "a sanitizer has the heap";
    constexpr uint32_t kWidth = 64;
    constexpr uint32_t kHeight = 48;
    const SyntheticGBuffer gbuffer =
        SyntheticGBuffer::render(*context_, SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
    SurfaceScene::World world = scene_.build(*context_, *library_, RayBackend::Bvh);
    Probe probe;
    probe.cube = environment_.map.cube;
    Probes probes = must(Probes::create(*library_, {{&probe, 1}, 16}));
    const PlanarMirror mirror = {};
    PlanarMirrors mirrors =
        must(PlanarMirrors::create(*library_, {.mirrors = {&mirror, 1}, .width = 16, .height = 16}));
    ReflectionsDesc desc = {kWidth, kHeight, everything(), true, true};
    Reflections reflections = must(Reflections::create(*library_, desc));
    must(reflections.setInputs(gbuffer.gbuffer, environment_.map));
    must(reflections.setRays(world.rays, world.surfaces));
    must(reflections.setProbes(probes));
    must(reflections.setPlanar(mirrors));
    constexpr VkImageUsageFlags kOutput =
        VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    gpu::Image output = must(gpu::Image::create(*context_, {"test/output", VK_FORMAT_R16G16B16A16_SFLOAT, kWidth,
                                                            kHeight, 1, 1, gpu::ImageShape::Flat, kOutput}));
    must(context_->submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame(*context_, commands)
            .hand(output, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }));
    uint64_t most = 0;
    for (uint32_t frame = 0; frame < 18; ++frame) {
        if (frame == 6)
            must(reflections.setOutputs({.composite = asHostImage(output)}));
        View view = camera_.view(kWidth, kHeight);
        view.frameIndex = frame;
        view.width = frame % 2 ? kWidth / 2 + frame : 0; // another extent each frame
        view.height = frame % 2 ? kHeight / 2 + frame : 0;
        if (frame == 6) {
            desc.settings.rays.sampleLights = true;
            must(reflections.setSettings(desc.settings));
        }
        if (frame == 12) { // instead of blur and upsampling
            desc.settings.denoise.enabled = true;
            must(reflections.setSettings(desc.settings));
        }
        must(context_->submitAndWait([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
            probes.record(commands);
            const uint64_t before = allocations();
            reflections.record(commands, view);
            most = std::max(most, allocations() - before);
        }));
    }
    EXPECT_EQ(most, 0u);
    EXPECT_FALSE(reflections.passTimes().empty());
    const uint64_t before = allocations();
    const std::string longer(100, '-');
    EXPECT_GT(allocations(), before) << longer;
}

TEST_F(RecordCostTest, AllocatesNothingThroughTheCInterface) {
    if (!countsAllocations())
        GTEST_SKIP() << "a sanitizer has the heap";
    const SyntheticGBuffer gbuffer = SyntheticGBuffer::render(*context_, SurfaceScene::seenBy(scene_), camera_, 64, 48);
    const gpu::AdoptedDevice handles = context_->handles();
    HostDevice device = {handles.instance, handles.physicalDevice, handles.device, handles.queueFamily,
                         handles.getInstanceProcAddr};
    const GlintContextDesc contextDesc = c_api::toC(device);
    GlintContext* context = nullptr;
    ASSERT_EQ(glint_context_adopt(&contextDesc, GLINT_C_ABI, &context), GLINT_SUCCESS) << glint_last_error();
    GlintReflectionsDesc desc = c_api::toC(ReflectionsDesc{64, 48});
    GlintReflections* reflections = nullptr;
    ASSERT_EQ(glint_reflections_create(context, &desc, &reflections), GLINT_SUCCESS) << glint_last_error();
    const GlintImage depth = c_api::toC(gbuffer.gbuffer.depth);
    const GlintImage normal = c_api::toC(gbuffer.gbuffer.normal);
    const GlintImage material = c_api::toC(gbuffer.gbuffer.material);
    const GlintImage lit = c_api::toC(gbuffer.gbuffer.litRadiance);
    GlintGBuffer images = c_api::toC(GBuffer());
    images.depth = &depth;
    images.normal = &normal;
    images.material = &material;
    images.litRadiance = &lit;
    ASSERT_EQ(glint_reflections_set_inputs(reflections, &images, nullptr), GLINT_SUCCESS) << glint_last_error();
    uint64_t most = 0;
    for (uint32_t frame = 1; frame <= 3; ++frame) {
        View view = camera_.view(64, 48);
        view.frameIndex = frame;
        const GlintView camera = c_api::toC(view);
        GlintImage result = c_api::toC(HostImage());
        must(context_->submitAndWait([&](VkCommandBuffer commands) {
            const uint64_t before = allocations();
            EXPECT_EQ(glint_reflections_record(reflections, commands, &camera, &result), GLINT_SUCCESS);
            most = std::max(most, allocations() - before);
        }));
        EXPECT_EQ(result.width, 64u);
    }
    EXPECT_EQ(most, 0u);
    glint_reflections_destroy(reflections);
    glint_context_destroy(context);
}

TEST_F(RecordCostTest, DoesNotWaitForTheGpu) {
    if (!countsAllocations())
        GTEST_SKIP() << "a sanitizer takes the time";
    constexpr uint32_t kWidth = 1280;
    constexpr uint32_t kHeight = 720;
    const SyntheticGBuffer gbuffer =
        SyntheticGBuffer::render(*context_, SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
    Reflections reflections = must(Reflections::create(*library_, {kWidth, kHeight, {}}));
    must(reflections.setInputs(gbuffer.gbuffer, environment_.map));
    std::deque<Recording> inFlight;
    std::vector<double> cpu;
    std::vector<double> wall;
    for (uint32_t frame = 0; frame < 12; ++frame) {
        if (inFlight.size() == 2) {
            inFlight.front().wait();
            inFlight.pop_front();
        }
        View view = camera_.view(kWidth, kHeight);
        view.frameIndex = frame;
        inFlight.emplace_back(*context_, [&](VkCommandBuffer commands) {
            const double cpuStart = threadMilliseconds();
            const double wallStart = wallMilliseconds();
            reflections.record(commands, view);
            cpu.push_back(threadMilliseconds() - cpuStart);
            wall.push_back(wallMilliseconds() - wallStart);
        });
        inFlight.back().submit();
    }
    RecordProperty("medianCpuMs", std::to_string(median(cpu)));
    EXPECT_LT(median(cpu), 0.2);
    EXPECT_LT(median(wall), 5) << "a frame takes far longer on the software driver";
}

} // namespace record_cost_test
} // namespace glint::test
