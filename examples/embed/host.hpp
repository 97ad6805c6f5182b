// SPDX-License-Identifier: MIT
// The host's Vulkan, which knows nothing of Glint but for the two lines marked 1: an instance, a device, a command
// buffer, images and buffers. A real engine has all this.
#pragma once

#include <glint/context.hpp>
#include <glint/gbuffer.hpp>
#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

[[noreturn]] inline void fail(const std::string& what) {
    std::fprintf(stderr, "embed: %s\n", what.c_str());
    std::exit(1);
}
inline void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS)
        fail(std::string(what) + " failed with VkResult " + std::to_string(result));
}

struct Host {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    bool draws = false; ///< the queue could
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::vector<VkBuffer> buffers;
    std::vector<VkImage> images;
    std::vector<VkImageView> views;
    std::vector<VkDeviceMemory> memories;

    Host();
    ~Host();
    Host(const Host&) = delete;
    bool createDevice(VkPhysicalDevice candidate);
    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties);
    VkBuffer createBuffer(size_t size, VkBufferUsageFlags usage, void** mapped);
    glint::HostImage upload(VkFormat format, uint32_t width, uint32_t height, const void* pixels, size_t size);
};

inline Host::Host() {
    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");

    uint32_t count = 16;
    VkPhysicalDevice candidates[16];
    if (vkEnumeratePhysicalDevices(instance, &count, candidates) < 0)
        count = 0;
    for (uint32_t i = 0; i < count && !device; ++i)
        if (createDevice(candidates[i]))
            physicalDevice = candidates[i];
    if (!device)
        fail("no device here has Vulkan 1.3 and what Glint requires");

    vkGetDeviceQueue(device, queueFamily, 0, &queue);
    const VkCommandPoolCreateInfo poolInfo = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0, queueFamily};
    check(vkCreateCommandPool(device, &poolInfo, nullptr, &pool), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo one = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool,
                                             VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    check(vkAllocateCommandBuffers(device, &one, &commands), "vkAllocateCommandBuffers");
}

inline bool Host::createDevice(VkPhysicalDevice candidate) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(candidate, &properties);
    uint32_t count = 16;
    VkQueueFamilyProperties families[16];
    vkGetPhysicalDeviceQueueFamilyProperties(candidate, &count, families);
    for (queueFamily = 0; queueFamily < count; ++queueFamily) // Glint draws nothing: a queue that computes will do
        if ((families[queueFamily].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0)
            break;
    if (properties.apiVersion < VK_API_VERSION_1_3 || queueFamily == count)
        return false;
    draws = (families[queueFamily].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;

    // 1. Glint adds what it needs to the features and extensions that the host asks for.
    VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
    VkPhysicalDeviceFeatures2 features = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12};
    glint::requireDeviceFeatures(&features.features, &v12, &v13);
    const std::span<const char* const> extensions = glint::requiredDeviceExtensions();

    const float priority = 1;
    VkDeviceQueueCreateInfo queueInfo = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    return vkCreateDevice(candidate, &info, nullptr, &device) == VK_SUCCESS;
}

inline Host::~Host() {
    for (VkImageView view : views)
        vkDestroyImageView(device, view, nullptr);
    for (VkImage image : images)
        vkDestroyImage(device, image, nullptr);
    for (VkBuffer buffer : buffers)
        vkDestroyBuffer(device, buffer, nullptr);
    for (VkDeviceMemory memory : memories)
        vkFreeMemory(device, memory, nullptr);
    vkDestroyCommandPool(device, pool, nullptr);
    vkDestroyDevice(device, nullptr);
    vkDestroyInstance(instance, nullptr);
}

inline VkDeviceMemory Host::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties types;
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &types);
    uint32_t type = 0;
    while (type < types.memoryTypeCount &&
           !((needs.memoryTypeBits >> type & 1) != 0 && (types.memoryTypes[type].propertyFlags & wanted) == wanted))
        ++type;
    const VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
    memories.push_back(VK_NULL_HANDLE);
    check(vkAllocateMemory(device, &info, nullptr, &memories.back()), "vkAllocateMemory");
    return memories.back();
}

inline VkBuffer Host::createBuffer(size_t size, VkBufferUsageFlags usage, void** mapped) {
    const VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, nullptr, 0, size, usage};
    buffers.push_back(VK_NULL_HANDLE);
    check(vkCreateBuffer(device, &info, nullptr, &buffers.back()), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffers.back(), &needs);
    const VkDeviceMemory memory =
        allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(device, buffers.back(), memory, 0), "vkBindBufferMemory");
    check(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, mapped), "vkMapMemory");
    return buffers.back();
}

/// Everything before waits and is visible: crude, and good enough for an example that submits once.
inline void changeLayout(VkCommandBuffer commands, const glint::HostImage& image, VkImageLayout from,
                         VkImageLayout to) {
    VkImageMemoryBarrier2 barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.image;
    VkImageAspectFlags aspects = VK_IMAGE_ASPECT_COLOR_BIT;
    if (image.format == VK_FORMAT_D32_SFLOAT_S8_UINT)
        aspects = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    barrier.subresourceRange = {aspects, 0, 1, 0, 1};
    VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

inline VkBufferImageCopy wholeImage(const glint::HostImage& image) {
    VkBufferImageCopy region = {};
    const bool depth = image.format == VK_FORMAT_D32_SFLOAT_S8_UINT;
    region.imageSubresource = {depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {image.width, image.height, 1};
    return region;
}

/// One image of the G-buffer. glint::HostImage is nothing but handles: image, view, format, size, layout.
inline glint::HostImage Host::upload(VkFormat format, uint32_t width, uint32_t height, const void* pixels,
                                     size_t size) {
    glint::HostImage result;
    result.format = format;
    result.width = width;
    result.height = height;
    VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    check(vkCreateImage(device, &info, nullptr, &result.image), "vkCreateImage");
    images.push_back(result.image);
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device, result.image, &needs);
    check(vkBindImageMemory(device, result.image, allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), 0),
          "vkBindImageMemory");
    VkImageViewCreateInfo viewInfo = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = result.image;
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = format;
    viewInfo.subresourceRange = {wholeImage(result).imageSubresource.aspectMask, 0, 1, 0, 1};
    check(vkCreateImageView(device, &viewInfo, nullptr, &result.view), "vkCreateImageView");
    views.push_back(result.view);

    void* staging = nullptr;
    const VkBuffer buffer = createBuffer(size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, &staging);
    std::memcpy(staging, pixels, size);
    const VkBufferImageCopy region = wholeImage(result);
    changeLayout(commands, result, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    vkCmdCopyBufferToImage(commands, buffer, result.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    changeLayout(commands, result, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    return result;
}
