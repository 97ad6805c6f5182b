#include "gpu/device_requirements.hpp"

#include "base/format.hpp"

#include <cstring>

namespace glint::gpu {
namespace {

/// Calls `visit(name, flag)` for each required feature of the given structs.
template <class Visit>
void visitFeatures(Demands demands, VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                   VkPhysicalDeviceVulkan13Features* v13, Visit visit) {
    const bool sources = demands != Demands::Screen;
    const bool programs = demands == Demands::Programs;
    if (core) {
        visit("shaderStorageImageExtendedFormats", core->shaderStorageImageExtendedFormats);
        if (programs) {
            visit("independentBlend", core->independentBlend);
            visit("shaderClipDistance", core->shaderClipDistance); // for the images of planar mirrors
        }
    }
    if (v12) {
        visit("scalarBlockLayout", v12->scalarBlockLayout);
        if (sources) {
            visit("runtimeDescriptorArray", v12->runtimeDescriptorArray);
            visit("shaderSampledImageArrayNonUniformIndexing", v12->shaderSampledImageArrayNonUniformIndexing);
            visit("descriptorBindingPartiallyBound", v12->descriptorBindingPartiallyBound);
            visit("bufferDeviceAddress", v12->bufferDeviceAddress);
        }
    }
    if (v13) {
        visit("synchronization2", v13->synchronization2);
        if (programs)
            visit("dynamicRendering", v13->dynamicRendering);
    }
}

bool hasSubgroupArithmetic(const Api& api, VkPhysicalDevice device) {
    VkPhysicalDeviceSubgroupProperties subgroups = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    properties.pNext = &subgroups;
    api.GetPhysicalDeviceProperties2(device, &properties);
    return (subgroups.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
           (subgroups.supportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT) != 0;
}

} // namespace

const std::vector<const char*>& requiredDeviceExtensions() {
    static const std::vector<const char*> names = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    return names;
}

const std::vector<const char*>& rayQueryExtensions() {
    static const std::vector<const char*> names = {VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                                                   VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                                   VK_KHR_RAY_QUERY_EXTENSION_NAME};
    return names;
}

bool supportsRayQuery(const Api& api, VkPhysicalDevice device) {
    for (const char* name : rayQueryExtensions())
        if (!hasExtension(api, device, name))
            return false;
    RayQueryFeatures rays;
    VkPhysicalDeviceFeatures2 features = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &rays.accelerationStructure};
    api.GetPhysicalDeviceFeatures2(device, &features);
    return rays.accelerationStructure.accelerationStructure && rays.rayQuery.rayQuery;
}

void requireFeatures(Demands demands, VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                     VkPhysicalDeviceVulkan13Features* v13) {
    visitFeatures(demands, core, v12, v13, [](const char*, VkBool32& flag) { flag = VK_TRUE; });
}

bool hasExtension(const Api& api, VkPhysicalDevice device, const char* name) {
    uint32_t count = 0;
    api.EnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    api.EnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    for (const VkExtensionProperties& extension : extensions)
        if (std::strcmp(extension.extensionName, name) == 0)
            return true;
    return false;
}

std::vector<std::string> missingRequirements(const Api& api, VkPhysicalDevice device, Demands demands) {
    std::vector<std::string> missing;
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    api.GetPhysicalDeviceProperties2(device, &properties);
    const uint32_t version = properties.properties.apiVersion;
    FeatureChain available;
    if (version < VK_API_VERSION_1_3) {
        missing.push_back(
            formatText("Vulkan 1.3 (has {}.{})", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version)));
        if (version < VK_API_VERSION_1_2)
            return missing;
        available.v12.pNext = nullptr; // a device older than 1.3 must not be queried for the 1.3 struct
    }
    api.GetPhysicalDeviceFeatures2(device, &available.base);
    visitFeatures(demands, &available.base.features, &available.v12, &available.v13,
                  [&](const char* name, VkBool32& flag) {
                      if (!flag)
                          missing.emplace_back(name);
                  });
    for (const char* name : requiredDeviceExtensions())
        if (!hasExtension(api, device, name))
            missing.emplace_back(name);
    if (!hasSubgroupArithmetic(api, device))
        missing.emplace_back("subgroup arithmetic in compute shaders");
    return missing;
}

} // namespace glint::gpu
