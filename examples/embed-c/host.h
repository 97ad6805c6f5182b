// SPDX-License-Identifier: MIT
// The host's Vulkan, which knows nothing of Glint but for the two lines marked 1: an instance, a device, a command
// buffer, images and buffers. A real engine has all this.
#pragma once

#include <glint/glint.h>
#include <vulkan/vulkan.h>

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { mostObjects = 16 };

typedef struct Host {
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    uint32_t queueFamily;
    bool draws; // the queue could
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer commands;
    VkBuffer buffers[mostObjects];
    VkImage images[mostObjects];
    VkImageView views[mostObjects];
    VkDeviceMemory memories[2 * mostObjects];
    uint32_t bufferCount, imageCount, memoryCount;
} Host;

static void fail(const char* what) {
    fprintf(stderr, "embed_c: %s\n", what);
    exit(1);
}
static void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        fprintf(stderr, "embed_c: %s failed with VkResult %d\n", what, (int)result);
        exit(1);
    }
}
static void checkGlint(GlintResult result) {
    if (result != GLINT_SUCCESS)
        fail(glint_last_error());
}

static bool createDevice(Host* host, VkPhysicalDevice candidate) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(candidate, &properties);
    uint32_t count = 16;
    VkQueueFamilyProperties families[16];
    vkGetPhysicalDeviceQueueFamilyProperties(candidate, &count, families);
    for (host->queueFamily = 0; host->queueFamily < count; ++host->queueFamily) // Glint draws nothing
        if ((families[host->queueFamily].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0)
            break;
    if (properties.apiVersion < VK_API_VERSION_1_3 || host->queueFamily == count)
        return false;
    host->draws = (families[host->queueFamily].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0;

    // 1. Glint adds what it needs to the features and extensions that the host asks for.
    VkPhysicalDeviceVulkan13Features v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features v12 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
    VkPhysicalDeviceFeatures2 features = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12};
    uint32_t extensionCount = 0;
    glint_require_device_features(&features.features, &v12, &v13, GLINT_DEVICE_DEMANDS_SOURCES);
    const char* const* extensions = glint_required_device_extensions(&extensionCount);

    const float priority = 1;
    VkDeviceQueueCreateInfo queueInfo = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = host->queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = extensionCount;
    info.ppEnabledExtensionNames = extensions;
    return vkCreateDevice(candidate, &info, NULL, &host->device) == VK_SUCCESS;
}

static void createHost(Host* host) {
    memset(host, 0, sizeof *host);
    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    check(vkCreateInstance(&info, NULL, &host->instance), "vkCreateInstance");

    uint32_t count = 16;
    VkPhysicalDevice candidates[16];
    if (vkEnumeratePhysicalDevices(host->instance, &count, candidates) < 0)
        count = 0;
    for (uint32_t i = 0; i < count && !host->device; ++i)
        if (createDevice(host, candidates[i]))
            host->physicalDevice = candidates[i];
    if (!host->device)
        fail("no device here has Vulkan 1.3 and what Glint requires");

    vkGetDeviceQueue(host->device, host->queueFamily, 0, &host->queue);
    const VkCommandPoolCreateInfo poolInfo = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, NULL, 0, host->queueFamily};
    check(vkCreateCommandPool(host->device, &poolInfo, NULL, &host->pool), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo one = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, NULL, host->pool,
                                             VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    check(vkAllocateCommandBuffers(host->device, &one, &host->commands), "vkAllocateCommandBuffers");
}

static void destroyHost(Host* host) {
    for (uint32_t i = 0; i < host->imageCount; ++i) {
        vkDestroyImageView(host->device, host->views[i], NULL);
        vkDestroyImage(host->device, host->images[i], NULL);
    }
    for (uint32_t i = 0; i < host->bufferCount; ++i)
        vkDestroyBuffer(host->device, host->buffers[i], NULL);
    for (uint32_t i = 0; i < host->memoryCount; ++i)
        vkFreeMemory(host->device, host->memories[i], NULL);
    vkDestroyCommandPool(host->device, host->pool, NULL);
    vkDestroyDevice(host->device, NULL);
    vkDestroyInstance(host->instance, NULL);
}

static VkDeviceMemory allocate(Host* host, VkMemoryRequirements needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties types;
    vkGetPhysicalDeviceMemoryProperties(host->physicalDevice, &types);
    uint32_t type = 0;
    while (type < types.memoryTypeCount &&
           !((needs.memoryTypeBits >> type & 1) != 0 && (types.memoryTypes[type].propertyFlags & wanted) == wanted))
        ++type;
    const VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, NULL, needs.size, type};
    VkDeviceMemory* memory = &host->memories[host->memoryCount++];
    check(vkAllocateMemory(host->device, &info, NULL, memory), "vkAllocateMemory");
    return *memory;
}

static VkBuffer createBuffer(Host* host, size_t size, VkBufferUsageFlags usage, void** mapped) {
    const VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, NULL, 0, size, usage};
    VkBuffer* buffer = &host->buffers[host->bufferCount++];
    check(vkCreateBuffer(host->device, &info, NULL, buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(host->device, *buffer, &needs);
    const VkDeviceMemory memory =
        allocate(host, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(host->device, *buffer, memory, 0), "vkBindBufferMemory");
    check(vkMapMemory(host->device, memory, 0, VK_WHOLE_SIZE, 0, mapped), "vkMapMemory");
    return *buffer;
}

// Everything before waits and is visible: crude, and good enough for an example that submits once.
static void changeLayout(VkCommandBuffer commands, const GlintImage* image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier2 barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image->image;
    barrier.subresourceRange.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT;
    if (image->format == VK_FORMAT_D32_SFLOAT_S8_UINT)
        barrier.subresourceRange.aspectMask = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    barrier.subresourceRange.levelCount = barrier.subresourceRange.layerCount = 1;
    VkDependencyInfo dependency = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

static VkBufferImageCopy wholeImage(const GlintImage* image) {
    const bool depth = image->format == VK_FORMAT_D32_SFLOAT_S8_UINT;
    VkBufferImageCopy region = {0};
    region.imageSubresource.aspectMask = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    region.imageSubresource.layerCount = 1;
    region.imageExtent.width = image->width;
    region.imageExtent.height = image->height;
    region.imageExtent.depth = 1;
    return region;
}

// One image of the G-buffer. A GlintImage is nothing but handles: image, view, format, size, layout.
static GlintImage upload(Host* host, VkFormat format, uint32_t width, uint32_t height, const void* pixels,
                         size_t size) {
    GlintImage result;
    glint_image_init(&result, sizeof result);
    result.format = format;
    result.width = width;
    result.height = height;
    VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent.width = width;
    info.extent.height = height;
    info.extent.depth = info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    check(vkCreateImage(host->device, &info, NULL, &result.image), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(host->device, result.image, &needs);
    check(vkBindImageMemory(host->device, result.image, allocate(host, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), 0),
          "vkBindImageMemory");
    const VkBufferImageCopy region = wholeImage(&result);
    VkImageViewCreateInfo viewInfo = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = result.image;
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = format;
    viewInfo.subresourceRange.aspectMask = region.imageSubresource.aspectMask;
    viewInfo.subresourceRange.levelCount = viewInfo.subresourceRange.layerCount = 1;
    check(vkCreateImageView(host->device, &viewInfo, NULL, &result.view), "vkCreateImageView");
    host->images[host->imageCount] = result.image;
    host->views[host->imageCount++] = result.view;

    void* staging = NULL;
    const VkBuffer buffer = createBuffer(host, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, &staging);
    memcpy(staging, pixels, size);
    changeLayout(host->commands, &result, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    vkCmdCopyBufferToImage(host->commands, buffer, result.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    changeLayout(host->commands, &result, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    return result;
}
