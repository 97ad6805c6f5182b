#include "gpu/device_requirements.hpp"

#include <fmt/format.h>

#include <cstring>

namespace glint::gpu {
namespace {

/// Calls `visit(name, flag)` for each feature that Glint needs, of the structs that are given.
template <class Visit>
void visitFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                   VkPhysicalDeviceVulkan13Features* v13, Visit visit) {
    if (core) {
        visit("shaderStorageImageExtendedFormats", core->shaderStorageImageExtendedFormats);
        visit("independentBlend", core->independentBlend);
    }
    if (v12) {
        visit("scalarBlockLayout", v12->scalarBlockLayout);
        visit("descriptorIndexing", v12->descriptorIndexing);
        visit("runtimeDescriptorArray", v12->runtimeDescriptorArray);
        visit("shaderSampledImageArrayNonUniformIndexing", v12->shaderSampledImageArrayNonUniformIndexing);
        visit("descriptorBindingPartiallyBound", v12->descriptorBindingPartiallyBound);
        visit("bufferDeviceAddress", v12->bufferDeviceAddress);
    }
    if (v13) {
        visit("synchronization2", v13->synchronization2);
        visit("dynamicRendering", v13->dynamicRendering);
    }
}

bool hasComputeBallots(const Api& api, VkPhysicalDevice device) {
    VkPhysicalDeviceSubgroupProperties subgroups = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    properties.pNext = &subgroups;
    api.GetPhysicalDeviceProperties2(device, &properties);
    return (subgroups.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
           (subgroups.supportedOperations & VK_SUBGROUP_FEATURE_BALLOT_BIT) != 0;
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

void requireFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                     VkPhysicalDeviceVulkan13Features* v13) {
    visitFeatures(core, v12, v13, [](const char*, VkBool32& flag) { flag = VK_TRUE; });
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

std::vector<std::string> missingRequirements(const Api& api, VkPhysicalDevice device) {
    std::vector<std::string> missing;
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    api.GetPhysicalDeviceProperties2(device, &properties);
    const uint32_t version = properties.properties.apiVersion;
    FeatureChain available;
    if (version < VK_API_VERSION_1_3) {
        missing.push_back(
            fmt::format("Vulkan 1.3 (has {}.{})", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version)));
        if (version < VK_API_VERSION_1_2)
            return missing;
        available.v12.pNext = nullptr; // the 1.3 struct may not be asked of an older device
    }
    api.GetPhysicalDeviceFeatures2(device, &available.base);
    visitFeatures(&available.base.features, &available.v12, &available.v13, [&](const char* name, VkBool32& flag) {
        if (!flag)
            missing.emplace_back(name);
    });
    if (!available.base.features.shaderClipDistance) // our own renderer's alone: hosts need not have it
        missing.emplace_back("shaderClipDistance");
    for (const char* name : requiredDeviceExtensions())
        if (!hasExtension(api, device, name))
            missing.emplace_back(name);
    if (!hasComputeBallots(api, device))
        missing.emplace_back("subgroup ballots in compute shaders");
    return missing;
}

} // namespace glint::gpu
