// What Glint requires of a Vulkan device, in one place: Context::adopt and `glint devices` check it, our programs
// enable it when they create a device, and docs/embedding.md lists it for hosts.
#pragma once

#include "gpu/api.hpp"

#include <string>
#include <vector>

namespace glint::gpu {

/// A chain of feature structs. Not copyable, as the structs point to each other.
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

/// How much of Glint the device must support. Each value includes the requirements of the values before it.
enum class Demands : uint8_t {
    Screen,   ///< the library without the parts that need image tables or buffer device addresses
    Sources,  ///< the whole library, with probes, planar mirrors and rays; compute shaders only
    Programs, ///< our own programs, which also draw
};

/// Returns the device extensions that every device must support.
const std::vector<const char*>& requiredDeviceExtensions();

/// Enables every required feature in the given structs; null structs are skipped.
void requireFeatures(Demands demands, VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                     VkPhysicalDeviceVulkan13Features* v13);

/// Features that ray queries require in addition; optional. Not copyable, like FeatureChain.
struct RayQueryFeatures {
    VkPhysicalDeviceAccelerationStructureFeaturesKHR accelerationStructure = {
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
    VkPhysicalDeviceRayQueryFeaturesKHR rayQuery = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};

    RayQueryFeatures() { accelerationStructure.pNext = &rayQuery; }
    RayQueryFeatures(const RayQueryFeatures&) = delete;
    RayQueryFeatures& operator=(const RayQueryFeatures&) = delete;
    void require() { accelerationStructure.accelerationStructure = rayQuery.rayQuery = VK_TRUE; }
};

/// Returns the extensions that ray queries require, in addition to requiredDeviceExtensions().
const std::vector<const char*>& rayQueryExtensions();

/// True if the device supports the extensions and features of ray queries.
bool supportsRayQuery(const Api& api, VkPhysicalDevice device);

/// Returns the requirements that this device does not meet, in words; empty if it meets all.
std::vector<std::string> missingRequirements(const Api& api, VkPhysicalDevice device, Demands demands);

bool hasExtension(const Api& api, VkPhysicalDevice device, const char* name);

} // namespace glint::gpu
