// The library's requirements of a device, and its behaviour on a device that offers no more. The test `compute_only`
// runs these on a device without graphics queues (tests/fakes/compute_only_layer.cpp).
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <gmock/gmock.h>

#include <cstring>

namespace glint::test {
namespace device_demands_test {

using testing::HasSubstr;

/// The test's device as a host would find it without some of its abilities: what the driver reports passes through
/// here.
struct LesserDevice {
    static inline PFN_vkGetInstanceProcAddr driver = nullptr;
    static inline VkInstance instance = VK_NULL_HANDLE;
    static inline bool scalarBlockLayout = true;
    static inline bool pushDescriptors = true;
    static inline bool subgroupArithmetic = true;
    static inline uint32_t apiVersion = 0; ///< 0: the driver's own

    template <class Function>
    static Function driverFunction(const char* name) {
        return reinterpret_cast<Function>(driver(instance, name));
    }
    /// Calls `visit` for the struct of this type in the chain, if there is one.
    template <class Struct, class Visit>
    static void find(void* chain, VkStructureType type, Visit visit) {
        for (auto* next = static_cast<VkBaseOutStructure*>(chain); next; next = next->pNext)
            if (next->sType == type)
                visit(*reinterpret_cast<Struct*>(next));
    }

    static VKAPI_ATTR void VKAPI_CALL features(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* out) {
        driverFunction<PFN_vkGetPhysicalDeviceFeatures2>("vkGetPhysicalDeviceFeatures2")(device, out);
        find<VkPhysicalDeviceVulkan12Features>(
            out->pNext, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
            [](VkPhysicalDeviceVulkan12Features& v12) { v12.scalarBlockLayout &= VkBool32(scalarBlockLayout); });
    }
    static VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
        driverFunction<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(device, out);
        if (apiVersion != 0)
            out->properties.apiVersion = apiVersion;
        find<VkPhysicalDeviceSubgroupProperties>(out->pNext, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES,
                                                 [](VkPhysicalDeviceSubgroupProperties& subgroups) {
                                                     if (!subgroupArithmetic)
                                                         subgroups.supportedOperations = VK_SUBGROUP_FEATURE_BASIC_BIT;
                                                 });
    }
    static VKAPI_ATTR VkResult VKAPI_CALL extensions(VkPhysicalDevice device, const char* layer, uint32_t* count,
                                                     VkExtensionProperties* out) {
        const VkResult result = driverFunction<PFN_vkEnumerateDeviceExtensionProperties>(
            "vkEnumerateDeviceExtensionProperties")(device, layer, count, out);
        for (uint32_t i = 0; out && i < *count; ++i)
            if (!pushDescriptors && std::strcmp(out[i].extensionName, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME) == 0)
                std::strcpy(out[i].extensionName, "VK_EXT_another");
        return result;
    }
    static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance of, const char* name) {
        if (std::strcmp(name, "vkGetPhysicalDeviceFeatures2") == 0)
            return reinterpret_cast<PFN_vkVoidFunction>(&features);
        if (std::strcmp(name, "vkGetPhysicalDeviceProperties2") == 0)
            return reinterpret_cast<PFN_vkVoidFunction>(&properties);
        if (std::strcmp(name, "vkEnumerateDeviceExtensionProperties") == 0)
            return reinterpret_cast<PFN_vkVoidFunction>(&extensions);
        return driver(of, name);
    }
};

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

TEST_F(DeviceDemandsTest, aDeviceThatLacksSomethingIsRefusedByName) {
    HostDevice lesser = device(DeviceDemands::Screen);
    LesserDevice::driver = lesser.getInstanceProcAddr;
    LesserDevice::instance = lesser.instance;
    lesser.getInstanceProcAddr = &LesserDevice::getInstanceProcAddr;
    EXPECT_TRUE(Context::adopt(lesser)) << "it lacks nothing yet";
    const auto refuses = [&](auto& ability, auto value, const char* name) {
        const auto before = std::exchange(ability, value);
        const Result<Context> adopted = Context::adopt(lesser);
        ability = before;
        ASSERT_FALSE(adopted) << name;
        EXPECT_EQ(adopted.error().code, ErrorCode::Unsupported) << name;
        EXPECT_EQ(adopted.error().message, gpu().info().name + " cannot run Glint: it lacks " + name);
    };
    refuses(LesserDevice::scalarBlockLayout, false, "scalarBlockLayout");
    refuses(LesserDevice::pushDescriptors, false, "VK_KHR_push_descriptor");
    refuses(LesserDevice::subgroupArithmetic, false, "subgroup arithmetic in compute shaders");
    refuses(LesserDevice::apiVersion, VK_API_VERSION_1_1, "Vulkan 1.3 (has 1.1)");
    EXPECT_TRUE(Context::adopt(lesser)) << "it lacks nothing again";
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

} // namespace device_demands_test
} // namespace glint::test
