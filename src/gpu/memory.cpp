#include "gpu/memory.hpp"

// VMA defines global functions and classes. Both must stay in this file: otherwise a host's own VMA could serve our
// calls, or collide with ours at link time. So VMA's functions are static and its classes are in our namespace, and the
// headers that VMA includes must be included before it.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <type_traits>
#include <utility>

#define VMA_STATIC_VULKAN_FUNCTIONS 0
#define VMA_DYNAMIC_VULKAN_FUNCTIONS 1
#define VMA_VULKAN_VERSION 1003000
#define VMA_CALL_PRE static
#define VMA_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wunused-function"
namespace glint::gpu::vma {
#include <vk_mem_alloc.h>
}
#pragma GCC diagnostic pop

namespace glint::gpu {

VkResult createAllocator(const Api& api, VkInstance instance, VkPhysicalDevice physicalDevice, VkDevice device,
                         bool addresses, const VkAllocationCallbacks* callbacks, vma::VmaAllocator_T*& allocator) {
    vma::VmaVulkanFunctions functions = {};
    functions.vkGetInstanceProcAddr = api.GetInstanceProcAddr;
    functions.vkGetDeviceProcAddr = api.GetDeviceProcAddr;
    vma::VmaAllocatorCreateInfo info = {};
    info.flags = addresses ? vma::VMA_ALLOCATOR_CREATE_BUFFER_DEVICE_ADDRESS_BIT : 0;
    info.physicalDevice = physicalDevice;
    info.device = device;
    info.instance = instance;
    info.vulkanApiVersion = VK_API_VERSION_1_3;
    info.pVulkanFunctions = &functions;
    // Images of a frame get memory of their own (from half of a block on), which leaves nothing unused; VMA's default
    // blocks, of up to 256 MiB, leave half of what they take.
    info.preferredLargeHeapBlockSize = VkDeviceSize{1} << 20;
    info.pAllocationCallbacks = callbacks;
    return vma::vmaCreateAllocator(&info, &allocator);
}

void destroyAllocator(vma::VmaAllocator_T* allocator) {
    vma::vmaDestroyAllocator(allocator);
}

size_t allocatedBytes(vma::VmaAllocator_T* allocator) {
    vma::VmaBudget budgets[VK_MAX_MEMORY_HEAPS] = {}; // stays 0 for heaps that the device does not have
    vma::vmaGetHeapBudgets(allocator, budgets);
    size_t sum = 0;
    for (const vma::VmaBudget& budget : budgets)
        sum += static_cast<size_t>(budget.statistics.allocationBytes);
    return sum;
}

size_t blockBytes(vma::VmaAllocator_T* allocator) {
    vma::VmaBudget budgets[VK_MAX_MEMORY_HEAPS] = {};
    vma::vmaGetHeapBudgets(allocator, budgets);
    size_t sum = 0;
    for (const vma::VmaBudget& budget : budgets)
        sum += static_cast<size_t>(budget.statistics.blockBytes);
    return sum;
}

VkDeviceSize bytesOf(vma::VmaAllocator_T* allocator, vma::VmaAllocation_T* allocation) {
    vma::VmaAllocationInfo info = {};
    vma::vmaGetAllocationInfo(allocator, allocation, &info);
    return info.size;
}

VkResult createImage(vma::VmaAllocator_T* allocator, const VkImageCreateInfo& info, VkImage& image,
                     vma::VmaAllocation_T*& allocation) {
    vma::VmaAllocationCreateInfo wanted = {};
    wanted.usage = vma::VMA_MEMORY_USAGE_AUTO;
    return vma::vmaCreateImage(allocator, &info, &wanted, &image, &allocation, nullptr);
}

void destroyImage(vma::VmaAllocator_T* allocator, VkImage image, vma::VmaAllocation_T* allocation) {
    vma::vmaDestroyImage(allocator, image, allocation);
}

VkResult createBuffer(vma::VmaAllocator_T* allocator, const VkBufferCreateInfo& info, BufferHome home, VkBuffer& buffer,
                      vma::VmaAllocation_T*& allocation, void*& mapped) {
    vma::VmaAllocationCreateInfo wanted = {};
    wanted.usage = vma::VMA_MEMORY_USAGE_AUTO;
    if (home == BufferHome::Upload)
        wanted.flags =
            vma::VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT | vma::VMA_ALLOCATION_CREATE_MAPPED_BIT;
    if (home == BufferHome::Readback)
        wanted.flags = vma::VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT | vma::VMA_ALLOCATION_CREATE_MAPPED_BIT;
    if (home != BufferHome::Device)
        wanted.requiredFlags = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    vma::VmaAllocationInfo allocated = {};
    const VkResult result = vma::vmaCreateBuffer(allocator, &info, &wanted, &buffer, &allocation, &allocated);
    mapped = allocated.pMappedData;
    return result;
}

void destroyBuffer(vma::VmaAllocator_T* allocator, VkBuffer buffer, vma::VmaAllocation_T* allocation) {
    vma::vmaDestroyBuffer(allocator, buffer, allocation);
}

} // namespace glint::gpu
