// Images and buffers: Vulkan handles, descriptions, and state for synchronization (gpu/sync.hpp).
#pragma once

#include "gpu/context.hpp"
#include "gpu/sync.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glint::gpu {

namespace vma {
struct VmaAllocation_T; // memory.hpp
}

enum class ImageShape : uint8_t { Flat, Array, Cube };

bool isDepth(VkFormat format); ///< with or without stencil

struct ImageDesc {
    std::string name; ///< shown by debuggers and in validation messages
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 1;
    uint32_t height = 1;
    uint32_t mips = 1;
    uint32_t layers = 1; ///< 6 for a cube
    ImageShape shape = ImageShape::Flat;
    VkImageUsageFlags usage = 0;
    uint32_t samples = 1; ///< samples per pixel
};

/// Owned (created here) or borrowed (a host's). Movable; destroys what it owns.
class Image {
public:
    Image() = default;
    static Result<Image> create(Context& context, const ImageDesc& desc);
    /// Wraps a host's image; `state` is the state in which the host left it. The handles must outlive the Image.
    static Image borrow(VkImage image, VkImageView view, const ImageDesc& desc, const ResourceState& state);
    /// Sets the state of a borrowed image again, after the host may have used it. Allocates nothing.
    void lendAgain(const ResourceState& state) { std::fill(states_.begin(), states_.end(), state); }
    ~Image() { destroy(); }
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept { return swap(other), *this; }

    explicit operator bool() const { return image_ != VK_NULL_HANDLE; }
    const ImageDesc& desc() const { return desc_; }
    uint32_t width() const { return desc_.width; }
    uint32_t height() const { return desc_.height; }
    VkImage handle() const { return image_; }
    VkImageView view() const { return view_; } ///< all mips and layers, for sampling
    VkImageView mipView(uint32_t mip) const;   ///< one mip, all layers, for storage; cubes are viewed as arrays
    VkImageAspectFlags aspect() const;         ///< the aspect that shaders read and write: colour, or depth alone
    VkImageAspectFlags barrierAspect() const;  ///< as aspect(), and stencil, whose layout changes with depth's
    std::vector<ResourceState>& states() { return states_; } ///< one per mip
    /// The layout in which every recording finds and leaves the image. UNDEFINED: `states` carry over from one
    /// recording to the next, which requires that all recordings are submitted in order.
    VkImageLayout rest() const { return rest_; }
    /// The recording that `states` belong to, for an image with a resting layout.
    uint64_t recording() const { return recording_; }
    void enterRecording(uint64_t recording) { recording_ = recording; }

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
    VkImageLayout rest_ = VK_IMAGE_LAYOUT_UNDEFINED;
    uint64_t recording_ = 0;
};

enum class BufferHome : uint8_t {
    Device,   ///< written by the GPU or by Frame::update
    Upload,   ///< mapped: the CPU writes, the GPU reads
    Readback, ///< mapped: the GPU writes, the CPU reads
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
    /// Requires usage SHADER_DEVICE_ADDRESS.
    VkDeviceAddress address() const;
    ResourceState& state() { return state_; }
    uint64_t recording() const { return recording_; } ///< the recording that `state` belongs to
    void enterRecording(uint64_t recording) { recording_ = recording; }

private:
    void destroy();
    void swap(Buffer& other);

    Context* context_ = nullptr;
    BufferDesc desc_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    vma::VmaAllocation_T* allocation_ = nullptr;
    void* mapped_ = nullptr;
    ResourceState state_;
    uint64_t recording_ = 0;
};

} // namespace glint::gpu
