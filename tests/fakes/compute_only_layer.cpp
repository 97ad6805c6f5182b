// A Vulkan layer that makes of any device one that a host of the library may have, and no more: every queue family
// computes and none draws, and the features that only our programs need are absent. Software drivers have one family
// that does everything. Enabled below the validation layer (VK_INSTANCE_LAYERS names validation first), it has that
// layer check every barrier, command and feature against such a device.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstring>
#include <map>
#include <mutex>
#include <type_traits>

namespace {

struct Below {
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    PFN_vkGetPhysicalDeviceQueueFamilyProperties queueFamilies = nullptr;
    PFN_vkGetPhysicalDeviceQueueFamilyProperties2 queueFamilies2 = nullptr;
    PFN_vkGetPhysicalDeviceFeatures features = nullptr;
    PFN_vkGetPhysicalDeviceFeatures2 features2 = nullptr;
};

std::mutex mutex;                                       // of the two maps
std::map<void*, Below> instances;                       // by dispatch table, which physical devices share with them
std::map<void*, PFN_vkGetDeviceProcAddr> deviceGetters; // by dispatch table

/// The loader's dispatch table: the first word of every dispatchable handle.
template <class Handle>
void* dispatchTable(Handle handle) {
    void* table = nullptr;
    std::memcpy(&table, handle, sizeof(table));
    return table;
}

template <class Handle>
Below belowOf(Handle handle) {
    const std::lock_guard lock(mutex);
    return instances[dispatchTable(handle)];
}

void hide(VkPhysicalDeviceFeatures& features) {
    features.independentBlend = features.shaderClipDistance = features.samplerAnisotropy = VK_FALSE;
}

/// Every struct of a chain begins with these.
void hideChained(void* chain) {
    for (auto* next = static_cast<VkBaseOutStructure*>(chain); next; next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES)
            reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(next)->dynamicRendering = VK_FALSE;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES)
            reinterpret_cast<VkPhysicalDeviceDynamicRenderingFeatures*>(next)->dynamicRendering = VK_FALSE;
    }
}

VKAPI_ATTR void VKAPI_CALL getFeatures(VkPhysicalDevice device, VkPhysicalDeviceFeatures* features) {
    belowOf(device).features(device, features);
    hide(*features);
}

VKAPI_ATTR void VKAPI_CALL getFeatures2(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) {
    belowOf(device).features2(device, features);
    hide(features->features);
    hideChained(features->pNext);
}

VKAPI_ATTR void VKAPI_CALL getQueueFamilies(VkPhysicalDevice device, uint32_t* count,
                                            VkQueueFamilyProperties* families) {
    belowOf(device).queueFamilies(device, count, families);
    for (uint32_t i = 0; families && i < *count; ++i)
        families[i].queueFlags &= VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
}

VKAPI_ATTR void VKAPI_CALL getQueueFamilies2(VkPhysicalDevice device, uint32_t* count,
                                             VkQueueFamilyProperties2* families) {
    belowOf(device).queueFamilies2(device, count, families);
    for (uint32_t i = 0; families && i < *count; ++i)
        families[i].queueFamilyProperties.queueFlags &= VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT;
}

template <class Info>
Info* findLink(const void* chain, VkStructureType type) {
    for (auto* next = static_cast<const Info*>(chain); next; next = static_cast<const Info*>(next->pNext))
        if (next->sType == type && next->function == VK_LAYER_LINK_INFO)
            return const_cast<Info*>(next); // the loader means layers to move its list on
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
    auto* link = findLink<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    Below below;
    below.getInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(below.getInstanceProcAddr(VK_NULL_HANDLE, "vkCreateInstance"));
    if (const VkResult result = create(info, allocator, instance); result != VK_SUCCESS)
        return result;
    const auto load = [&](auto& function, const char* name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(below.getInstanceProcAddr(*instance, name));
    };
    load(below.queueFamilies, "vkGetPhysicalDeviceQueueFamilyProperties");
    load(below.queueFamilies2, "vkGetPhysicalDeviceQueueFamilyProperties2");
    load(below.features, "vkGetPhysicalDeviceFeatures");
    load(below.features2, "vkGetPhysicalDeviceFeatures2");
    const std::lock_guard lock(mutex);
    instances[dispatchTable(*instance)] = below;
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physicalDevice, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
    auto* link = findLink<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link)
        return VK_ERROR_INITIALIZATION_FAILED;
    const PFN_vkGetInstanceProcAddr getInstanceProcAddr = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    const PFN_vkGetDeviceProcAddr getDeviceProcAddr = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(getInstanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
    const VkResult result = create(physicalDevice, info, allocator, device);
    if (result == VK_SUCCESS) {
        const std::lock_guard lock(mutex);
        deviceGetters[dispatchTable(*device)] = getDeviceProcAddr;
    }
    return result;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&getDeviceProcAddr);
    const std::lock_guard lock(mutex);
    const auto below = deviceGetters.find(dispatchTable(device));
    return below == deviceGetters.end() ? nullptr : below->second(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
    const auto is = [&](const char* other) { return std::strcmp(name, other) == 0; };
    if (is("vkGetInstanceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getInstanceProcAddr);
    if (is("vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getDeviceProcAddr);
    if (is("vkCreateInstance"))
        return reinterpret_cast<PFN_vkVoidFunction>(&createInstance);
    if (is("vkCreateDevice"))
        return reinterpret_cast<PFN_vkVoidFunction>(&createDevice);
    if (is("vkGetPhysicalDeviceFeatures"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getFeatures);
    if (is("vkGetPhysicalDeviceFeatures2") || is("vkGetPhysicalDeviceFeatures2KHR"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getFeatures2);
    if (is("vkGetPhysicalDeviceQueueFamilyProperties"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getQueueFamilies);
    if (is("vkGetPhysicalDeviceQueueFamilyProperties2") || is("vkGetPhysicalDeviceQueueFamilyProperties2KHR"))
        return reinterpret_cast<PFN_vkVoidFunction>(&getQueueFamilies2);
    return instance ? belowOf(instance).getInstanceProcAddr(instance, name) : nullptr;
}

} // namespace

extern "C" __attribute__((visibility("default"))) VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* interface) {
    interface->loaderLayerInterfaceVersion = 2;
    interface->pfnGetInstanceProcAddr = &getInstanceProcAddr;
    interface->pfnGetDeviceProcAddr = &getDeviceProcAddr;
    interface->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
