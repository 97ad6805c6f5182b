// The library's requirements of a device, and its behaviour on a device that offers no more. The test `compute_only`
// runs these on a device without graphics queues (tests/fakes/compute_only_layer.cpp).
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace {

using testing::HasSubstr;

class DeviceDemandsTest : public LibraryTest {
protected:
    static HostDevice device(DeviceDemands demands) {
        const gpu::AdoptedDevice handles = gpu().handles();
        HostDevice device = {handles.instance, handles.physicalDevice, handles.device, handles.queueFamily,
                             handles.getInstanceProcAddr};
        device.demands = demands;
        return device;
    }
};

TEST_F(DeviceDemandsTest, nothingThatOnlyDrawsIsRequired) {
    for (const DeviceDemands demands : {DeviceDemands::Screen, DeviceDemands::Sources}) {
        VkPhysicalDeviceFeatures core = {};
        VkPhysicalDeviceVulkan12Features v12 = {};
        VkPhysicalDeviceVulkan13Features v13 = {};
        requireDeviceFeatures(&core, &v12, &v13, demands);
        EXPECT_TRUE(core.shaderStorageImageExtendedFormats);
        EXPECT_TRUE(v12.scalarBlockLayout);
        EXPECT_TRUE(v13.synchronization2);
        EXPECT_FALSE(core.independentBlend);
        EXPECT_FALSE(core.shaderClipDistance);
        EXPECT_FALSE(core.samplerAnisotropy);
        EXPECT_FALSE(v13.dynamicRendering);
        const bool sources = demands == DeviceDemands::Sources;
        EXPECT_EQ(v12.runtimeDescriptorArray == VK_TRUE, sources);
        EXPECT_EQ(v12.shaderSampledImageArrayNonUniformIndexing == VK_TRUE, sources);
        EXPECT_EQ(v12.descriptorBindingPartiallyBound == VK_TRUE, sources);
        EXPECT_EQ(v12.bufferDeviceAddress == VK_TRUE, sources);
    }
}

TEST_F(DeviceDemandsTest, aDeviceForTheScreenAloneReflectsAndRefusesTheOtherSources) {
    Context screen = must(Context::adopt(device(DeviceDemands::Screen)));
    const ReflectionsDesc desc = {32, 18, plainSettings()};
    const SyntheticGBuffer gbuffer = SyntheticGBuffer::render(gpu(), floorAndWall(), SyntheticCamera(), 32, 18);
    const auto reflected = [&](Context& context) {
        Reflections made = must(Reflections::create(context, desc));
        must(made.setInputs(gbuffer.gbuffer));
        HostImage image;
        run([&](VkCommandBuffer commands) { image = made.record(commands, SyntheticCamera().view(32, 18)); });
        return download(gpu(), image);
    };
    const std::vector<float> picture = reflected(screen);
    EXPECT_EQ(picture, reflected(library()));
    EXPECT_NE(picture, download(gpu(), gbuffer.gbuffer.litRadiance));

    const TestEnvironment cube = TestEnvironment::make(gpu(), 16, 1, [](auto&, uint32_t) { return glm::vec3(1); });
    Probe probe;
    probe.cube = cube.map.cube;
    const PlanarMirror mirror;
    const SurfaceMaterial material;
    const auto refuses = [](const auto& result) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::Unsupported);
        EXPECT_THAT(result.error().message, HasSubstr("DeviceDemands::Sources"));
    };
    refuses(Probes::create(screen, {.probes = {&probe, 1}}));
    refuses(PlanarMirrors::create(screen, {{&mirror, 1}, 32, 18, {}}));
    refuses(SurfaceTable::create(screen, {.materials = {&material, 1}}));

    HostDevice rays = device(DeviceDemands::Screen);
    rays.rayQuery = true;
    const Result<Context> both = Context::adopt(rays);
    ASSERT_FALSE(both);
    EXPECT_EQ(both.error().code, ErrorCode::InvalidArgument);
}

} // namespace
} // namespace glint::test
