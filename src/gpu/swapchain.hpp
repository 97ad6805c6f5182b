// Pictures on their way into a window. The window itself belongs to whoever made it; here is only what Vulkan knows of
// it: a surface, and the images that it shows.
#pragma once

#include "gpu/resources.hpp"

#include <memory>

namespace glint::gpu {

/// What became of a picture that was to be shown.
enum class Presented : uint8_t {
    Shown,
    NotShown,    ///< the window has no area (it is minimized) or is just changing its size; nothing to do
    SurfaceLost, ///< the window system took the surface away: make another one, and another Swapchain
};

class Swapchain {
public:
    /// `surface` belongs to the swapchain from here on, also where there is an error. `context` presents and outlives
    /// it. Errors: Unsupported where the device cannot show pictures there.
    static Result<std::unique_ptr<Swapchain>> create(Context& context, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Copies `picture` (RGBA8_UNORM with TRANSFER_SRC usage) into the window and waits until that is done, at most for
    /// the display's next refresh and a second. Images are made anew whenever the picture's size changes; a picture
    /// whose size is not the window's is not shown.
    /// Errors: DeviceLost, OutOfMemory.
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
    std::vector<VkSemaphore> copied_; ///< one an image: the presentation may still hold it when the next one starts
    VkSemaphore acquired_ = VK_NULL_HANDLE;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    bool outdated_ = true;
};

} // namespace glint::gpu
