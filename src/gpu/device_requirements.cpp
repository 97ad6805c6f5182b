#include "gpu/device_requirements.hpp"

#include <fmt/format.h>

#include <cstring>

namespace glint::gpu {
namespace {

/// Calls `visit(name, flag)` for each feature that Glint needs.
template <class Visit>
void visitFeatures(FeatureChain& chain, Visit visit) {
    visit("shaderStorageImageExtendedFormats", chain.base.features.shaderStorageImageExtendedFormats);
    visit("independentBlend", chain.base.features.independentBlend);
    visit("scalarBlockLayout", chain.v12.scalarBlockLayout);
    visit("descriptorIndexing", chain.v12.descriptorIndexing);
    visit("runtimeDescriptorArray", chain.v12.runtimeDescriptorArray);
    visit("shaderSampledImageArrayNonUniformIndexing", chain.v12.shaderSampledImageArrayNonUniformIndexing);
    visit("descriptorBindingPartiallyBound", chain.v12.descriptorBindingPartiallyBound);
    visit("bufferDeviceAddress", chain.v12.bufferDeviceAddress);
    visit("synchronization2", chain.v13.synchronization2);
    visit("dynamicRendering", chain.v13.dynamicRendering);
}

} // namespace

const std::vector<const char*>& requiredDeviceExtensions() {
    static const std::vector<const char*> names = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
    return names;
}

void requireFeatures(FeatureChain& enabled) {
    visitFeatures(enabled, [](const char*, VkBool32& flag) { flag = VK_TRUE; });
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
    visitFeatures(available, [&](const char* name, const VkBool32& flag) {
        if (!flag)
            missing.emplace_back(name);
    });
    for (const char* name : requiredDeviceExtensions())
        if (!hasExtension(api, device, name))
            missing.emplace_back(name);
    return missing;
}

} // namespace glint::gpu
