// What Glint asks of a Vulkan device, in one place: checked by `glint devices`, enabled when we create a device, and
// listed for hosts in docs/embedding.md.
#pragma once

#include "gpu/api.hpp"

#include <string>
#include <vector>

namespace glint::gpu {

/// A chain of feature structs. Not copyable: the structs point at each other.
struct FeatureChain {
    VkPhysicalDeviceFeatures2 base = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};

    FeatureChain() {
        base.pNext = &v12;
        v12.pNext = &v13;
    }
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;
};

/// The device extensions that every device must offer.
const std::vector<const char*>& requiredDeviceExtensions();

/// Switches on every feature that Glint needs in the structs that are given; null ones are skipped.
void requireFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                     VkPhysicalDeviceVulkan13Features* v13);

/// What ray queries need on top; optional. Not copyable, as above.
struct RayQueryFeatures {
    VkPhysicalDeviceAccelerationStructureFeaturesKHR accelerationStructure = {
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
    VkPhysicalDeviceRayQueryFeaturesKHR rayQuery = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};

    RayQueryFeatures() { accelerationStructure.pNext = &rayQuery; }
    RayQueryFeatures(const RayQueryFeatures&) = delete;
    RayQueryFeatures& operator=(const RayQueryFeatures&) = delete;
    void require() { accelerationStructure.accelerationStructure = rayQuery.rayQuery = VK_TRUE; }
};

/// The extensions that ray queries need, besides those above.
const std::vector<const char*>& rayQueryExtensions();

/// Does the device offer the extensions and the features?
bool supportsRayQuery(const Api& api, VkPhysicalDevice device);

/// In words, what this device lacks; empty if it can run Glint.
std::vector<std::string> missingRequirements(const Api& api, VkPhysicalDevice device);

bool hasExtension(const Api& api, VkPhysicalDevice device, const char* name);

} // namespace glint::gpu
