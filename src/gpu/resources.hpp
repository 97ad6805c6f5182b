// Images and buffers: their Vulkan handles, what they are, and what has been done to them (gpu/sync.hpp).
#pragma once

#include "gpu/context.hpp"
#include "gpu/sync.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glint::gpu {

namespace vma {
struct VmaAllocation_T; // memory.hpp
}

enum class ImageShape : uint8_t { Flat, Array, Cube };

struct ImageDesc {
    std::string name; ///< shown by debuggers and validation messages
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 1;
    uint32_t height = 1;
    uint32_t mips = 1;
    uint32_t layers = 1; ///< 6 for a cube
    ImageShape shape = ImageShape::Flat;
    VkImageUsageFlags usage = 0;
    uint32_t samples = 1; ///< a pixel
};

/// Owned (created here) or borrowed (a host's). Movable; destroys what it owns.
class Image {
public:
    Image() = default;
    static Result<Image> create(Context& context, const ImageDesc& desc);
    /// A host's image; `state` is how the host left it. The handles must outlive the Image.
    static Image borrow(VkImage image, VkImageView view, const ImageDesc& desc, const ResourceState& state);
    ~Image() { destroy(); }
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept { return swap(other), *this; }

    explicit operator bool() const { return image_ != VK_NULL_HANDLE; }
    const ImageDesc& desc() const { return desc_; }
    uint32_t width() const { return desc_.width; }
    uint32_t height() const { return desc_.height; }
    VkImage handle() const { return image_; }
    VkImageView view() const { return view_; } ///< all mips and layers, for sampling
    VkImageView mipView(uint32_t mip) const;   ///< one mip, all layers: as an array for cubes, for storing
    VkImageAspectFlags aspect() const;         ///< what is read and written: colour, or depth alone
    VkImageAspectFlags barrierAspect() const;  ///< the same with stencil, whose layout goes with depth's
    std::vector<ResourceState>& states() { return states_; } ///< one a mip

private:
    void destroy();
    void swap(Image& other);

    Context* context_ = nullptr; ///< null: borrowed
    ImageDesc desc_;
    VkImage image_ = VK_NULL_HANDLE;
    vma::VmaAllocation_T* allocation_ = nullptr;
    VkImageView view_ = VK_NULL_HANDLE;
    std::vector<VkImageView> mipViews_;
    std::vector<ResourceState> states_;
};

enum class BufferHome : uint8_t {
    Device,   ///< written by the GPU or by Frame::update
    Upload,   ///< mapped; the CPU writes, the GPU reads
    Readback, ///< mapped; the GPU writes, the CPU reads
};

struct BufferDesc {
    std::string name;
    size_t size = 0; ///< bytes, > 0
    VkBufferUsageFlags usage = 0;
    BufferHome home = BufferHome::Device;
};

class Buffer {
public:
    Buffer() = default;
    static Result<Buffer> create(Context& context, const BufferDesc& desc);
    ~Buffer() { destroy(); }
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept { return swap(other), *this; }

    explicit operator bool() const { return buffer_ != VK_NULL_HANDLE; }
    VkBuffer handle() const { return buffer_; }
    size_t size() const { return desc_.size; }
    const std::string& name() const { return desc_.name; }
    void* mapped() const { return mapped_; } ///< null for BufferHome::Device
    /// Needs ray queries enabled and usage SHADER_DEVICE_ADDRESS.
    VkDeviceAddress address() const;
    ResourceState& state() { return state_; }

private:
    void destroy();
    void swap(Buffer& other);

    Context* context_ = nullptr;
    BufferDesc desc_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    vma::VmaAllocation_T* allocation_ = nullptr;
    void* mapped_ = nullptr;
    ResourceState state_;
};

} // namespace glint::gpu
