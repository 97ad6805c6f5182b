// Presents images to a window. The window is owned by its creator; this class holds its Vulkan part: a surface and the
// images that it shows.
#pragma once

#include "gpu/resources.hpp"

#include <memory>

namespace glint::gpu {

/// Result of presenting an image.
enum class Presented : uint8_t {
    Shown,
    NotShown,    ///< the window has no area (it is minimized) or is changing its size; no action needed
    SurfaceLost, ///< the window system has removed the surface: create another surface and another Swapchain
};

class Swapchain {
public:
    /// The swapchain takes ownership of `surface`, also on error. `context` needs ContextDesc::windowExtensions and
    /// must outlive the swapchain. Errors: Unsupported if the device cannot present to the surface.
    static Result<std::unique_ptr<Swapchain>> create(Context& context, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Copies `picture` (RGBA8_UNORM with TRANSFER_SRC usage) into the window and waits until the copy is done, at most
    /// until the display's next refresh plus a second. The swapchain's images are recreated when the picture's size
    /// changes; a picture whose size differs from the window's is not shown. Errors: DeviceLost, OutOfMemory.
    Result<Presented> present(Image& picture);

private:
    explicit Swapchain(Context& context) : context_(context) {}
    Result<Presented> make(uint32_t width, uint32_t height);
    Result<void> copy(Image& picture, uint32_t index);
    void release();

    Context& context_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_ = {};
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    std::vector<Image> images_;
    /// One per image, as a presentation may still use its semaphore when the next one starts.
    std::vector<VkSemaphore> copied_;
    VkSemaphore acquired_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    bool outdated_ = true;
};

} // namespace glint::gpu
