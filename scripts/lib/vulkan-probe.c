// Exits with 0 when the Vulkan loader finds a device that Glint can work on, naming it; else with 1.
// Vulkan 1.3, descriptor indexing and buffer device address are needed everywhere. A software device must have ray
// query too: a Mesa without it is older than the one that set-up can unpack, so it is passed over.
#include <stdio.h>
#include <string.h>
#include <vulkan/vulkan.h>

static int has_ray_query(VkPhysicalDevice device) {
    static VkExtensionProperties list[1024];
    uint32_t count = 1024;
    vkEnumerateDeviceExtensionProperties(device, NULL, &count, list);
    for (uint32_t i = 0; i < count; ++i)
        if (!strcmp(list[i].extensionName, VK_KHR_RAY_QUERY_EXTENSION_NAME))
            return 1;
    return 0;
}

static int is_usable(VkPhysicalDevice device, const VkPhysicalDeviceProperties* properties) {
    if (properties->apiVersion < VK_API_VERSION_1_3)
        return 0;
    VkPhysicalDeviceVulkan12Features vulkan12 = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceFeatures2 features = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &vulkan12};
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (!vulkan12.descriptorIndexing || !vulkan12.runtimeDescriptorArray || !vulkan12.bufferDeviceAddress)
        return 0;
    return properties->deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU || has_ray_query(device);
}

int main(void) {
    VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_3};
    VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    VkInstance instance;
    if (vkCreateInstance(&info, NULL, &instance) != VK_SUCCESS)
        return 1;
    VkPhysicalDevice devices[16];
    uint32_t count = 16;
    if (vkEnumeratePhysicalDevices(instance, &count, devices) < 0)
        return 1;
    for (uint32_t i = 0; i < count; ++i) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        if (!is_usable(devices[i], &properties))
            continue;
        puts(properties.deviceName);
        return 0;
    }
    return 1;
}
