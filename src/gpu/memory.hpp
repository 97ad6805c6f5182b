// Device memory: images and buffers with memory bound, from VMA. VMA itself is seen by memory.cpp alone, for a host
// that links Glint may have a VMA of its own, of another version or set up in another way.
#pragma once

#include "gpu/api.hpp"
#include "gpu/resources.hpp"

namespace glint::gpu {

/// Memory may be reached by device address, as acceleration structures and the vertices of ray hits are.
VkResult createAllocator(const Api& api, VkInstance instance, VkPhysicalDevice physicalDevice, VkDevice device,
                         vma::VmaAllocator_T*& allocator);
void destroyAllocator(vma::VmaAllocator_T* allocator);
/// Bytes of all images and buffers that are alive, of every kind of memory, mapped or not.
size_t allocatedBytes(vma::VmaAllocator_T* allocator);

VkResult createImage(vma::VmaAllocator_T* allocator, const VkImageCreateInfo& info, VkImage& image,
                     vma::VmaAllocation_T*& allocation);
void destroyImage(vma::VmaAllocator_T* allocator, VkImage image, vma::VmaAllocation_T* allocation);

/// `mapped` is null for a buffer of the device.
VkResult createBuffer(vma::VmaAllocator_T* allocator, const VkBufferCreateInfo& info, BufferHome home, VkBuffer& buffer,
                      vma::VmaAllocation_T*& allocation, void*& mapped);
void destroyBuffer(vma::VmaAllocator_T* allocator, VkBuffer buffer, vma::VmaAllocation_T* allocation);

} // namespace glint::gpu
