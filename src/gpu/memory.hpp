// Device memory: images and buffers with bound memory, allocated by VMA. Only memory.cpp includes VMA, as a host that
// links Glint may have its own VMA of another version or configuration.
#pragma once

#include "gpu/api.hpp"
#include "gpu/resources.hpp"

namespace glint::gpu {

/// `addresses`: allows buffer device addresses, which acceleration structures and the vertices of ray hits need;
/// requires the feature bufferDeviceAddress.
VkResult createAllocator(const Api& api, VkInstance instance, VkPhysicalDevice physicalDevice, VkDevice device,
                         bool addresses, const VkAllocationCallbacks* callbacks, vma::VmaAllocator_T*& allocator);
void destroyAllocator(vma::VmaAllocator_T* allocator);
/// Returns the bytes of all existing images and buffers, in all kinds of memory, mapped or not.
size_t allocatedBytes(vma::VmaAllocator_T* allocator);

/// Returns the bytes of the driver's allocations, which images and buffers share.
size_t blockBytes(vma::VmaAllocator_T* allocator);
/// Returns the bytes of one image or buffer, with what its alignment adds.
VkDeviceSize bytesOf(vma::VmaAllocator_T* allocator, vma::VmaAllocation_T* allocation);

VkResult createImage(vma::VmaAllocator_T* allocator, const VkImageCreateInfo& info, VkImage& image,
                     vma::VmaAllocation_T*& allocation);
void destroyImage(vma::VmaAllocator_T* allocator, VkImage image, vma::VmaAllocation_T* allocation);

/// `mapped` is set to null for a buffer in device memory.
VkResult createBuffer(vma::VmaAllocator_T* allocator, const VkBufferCreateInfo& info, BufferHome home, VkBuffer& buffer,
                      vma::VmaAllocation_T*& allocation, void*& mapped);
void destroyBuffer(vma::VmaAllocator_T* allocator, VkBuffer buffer, vma::VmaAllocation_T* allocation);

} // namespace glint::gpu
