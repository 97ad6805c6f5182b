#include "lab/gpu/swapchain.hpp"

#include "gpu/pass.hpp"

#include <algorithm>
#include <optional>

namespace glint::gpu {
namespace {

constexpr uint64_t kLongestWait = 1'000'000'000; ///< ns; a window that is not visible may never refresh

Error failed(const char* what, VkResult result) {
    const ErrorCode code = result == VK_ERROR_DEVICE_LOST            ? ErrorCode::DeviceLost
                           : result == VK_ERROR_OUT_OF_DEVICE_MEMORY ? ErrorCode::OutOfMemory
                                                                     : ErrorCode::Unsupported;
    return makeError(code, "{} failed with VkResult {}", what, static_cast<int>(result));
}

/// The colours are already sRGB-encoded: formats that would encode them again, or interpret them differently, are
/// rejected.
std::optional<VkSurfaceFormatKHR> chooseFormat(const std::vector<VkSurfaceFormatKHR>& formats) {
    for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
        for (const VkSurfaceFormatKHR& format : formats)
            if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return format;
    return std::nullopt;
}

/// True if images can be copied into the window. A lost surface passes: presenting to it reports the loss.
bool takesCopies(const Context& context, VkSurfaceKHR surface) {
    VkSurfaceCapabilitiesKHR capabilities = {};
    const VkResult result =
        context.api().GetPhysicalDeviceSurfaceCapabilitiesKHR(context.physicalDevice(), surface, &capabilities);
    return result != VK_SUCCESS || (capabilities.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) != 0;
}

/// State of an image that has just been acquired: its content is undefined, and all stages have waited for the
/// semaphore.
ResourceState justAcquired() {
    ResourceState state;
    state.writeStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    return state;
}

} // namespace

Result<std::unique_ptr<Swapchain>> Swapchain::create(Context& context, VkSurfaceKHR surface) {
    std::unique_ptr<Swapchain> swapchain(new Swapchain(context));
    swapchain->surface_ = surface;
    const Api& api = context.api();
    VkBool32 supported = VK_FALSE;
    api.GetPhysicalDeviceSurfaceSupportKHR(context.physicalDevice(), context.queueFamily(), surface, &supported);
    uint32_t count = 0;
    api.GetPhysicalDeviceSurfaceFormatsKHR(context.physicalDevice(), surface, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    api.GetPhysicalDeviceSurfaceFormatsKHR(context.physicalDevice(), surface, &count, formats.data());
    const std::optional<VkSurfaceFormatKHR> format = chooseFormat(formats);
    if (!supported || !format || !takesCopies(context, surface))
        return makeError(ErrorCode::Unsupported, "{} cannot show pictures in this window", context.info().name);
    swapchain->format_ = *format;

    const VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0,
                                          context.queueFamily()};
    const VkFenceCreateInfo fence = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    const VkSemaphoreCreateInfo semaphore = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkResult result = api.CreateCommandPool(context.device(), &pool, nullptr, &swapchain->pool_);
    if (result == VK_SUCCESS) {
        const VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr,
                                                      swapchain->pool_, VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
        result = api.AllocateCommandBuffers(context.device(), &allocate, &swapchain->commands_);
    }
    if (result == VK_SUCCESS)
        result = api.CreateFence(context.device(), &fence, nullptr, &swapchain->fence_);
    if (result == VK_SUCCESS)
        result = api.CreateSemaphore(context.device(), &semaphore, nullptr, &swapchain->acquired_);
    if (result != VK_SUCCESS)
        return failed("making what a window needs", result);
    return swapchain;
}

Swapchain::~Swapchain() {
    const Api& api = context_.api();
    release();
    api.DestroySemaphore(context_.device(), acquired_, nullptr);
    api.DestroyFence(context_.device(), fence_, nullptr);
    api.DestroyCommandPool(context_.device(), pool_, nullptr);
    api.DestroySurfaceKHR(context_.instance(), surface_, nullptr);
}

void Swapchain::release() {
    const Api& api = context_.api();
    api.QueueWaitIdle(context_.queue()); // presentations use semaphores, and no fence signals when that use ends
    images_.clear();
    for (VkSemaphore semaphore : copied_)
        api.DestroySemaphore(context_.device(), semaphore, nullptr);
    copied_.clear();
    api.DestroySwapchainKHR(context_.device(), swapchain_, nullptr);
    swapchain_ = VK_NULL_HANDLE;
}

Result<Presented> Swapchain::make(uint32_t width, uint32_t height) {
    const Api& api = context_.api();
    release();
    VkSurfaceCapabilitiesKHR surface = {};
    VkResult result = api.GetPhysicalDeviceSurfaceCapabilitiesKHR(context_.physicalDevice(), surface_, &surface);
    if (result == VK_ERROR_SURFACE_LOST_KHR)
        return Presented::SurfaceLost;
    if (result != VK_SUCCESS)
        return failed("asking for the window's size", result);
    const bool free = surface.currentExtent.width == UINT32_MAX; // the size of `picture` decides, as on Wayland
    const VkExtent2D extent = free ? VkExtent2D{width, height} : surface.currentExtent;
    if (extent.width != width || extent.height != height || width == 0 || height == 0)
        return Presented::NotShown;
    VkSwapchainCreateInfoKHR info = {VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface_;
    info.minImageCount = std::max(surface.minImageCount, 2u);
    if (surface.maxImageCount > 0)
        info.minImageCount = std::min(info.minImageCount, surface.maxImageCount);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = surface.currentTransform;
    info.compositeAlpha = (surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR; // supported by every device, without tearing
    info.clipped = VK_TRUE;
    result = api.CreateSwapchainKHR(context_.device(), &info, nullptr, &swapchain_);
    if (result == VK_ERROR_SURFACE_LOST_KHR)
        return Presented::SurfaceLost;
    if (result != VK_SUCCESS)
        return failed("vkCreateSwapchainKHR", result);

    uint32_t count = 0;
    api.GetSwapchainImagesKHR(context_.device(), swapchain_, &count, nullptr);
    std::vector<VkImage> handles(count);
    api.GetSwapchainImagesKHR(context_.device(), swapchain_, &count, handles.data());
    for (VkImage handle : handles) {
        VkSemaphore copied = VK_NULL_HANDLE;
        const VkSemaphoreCreateInfo semaphore = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
        images_.push_back(Image::borrow(handle, VK_NULL_HANDLE, {"window", format_.format, extent.width, extent.height},
                                        justAcquired()));
        result = api.CreateSemaphore(context_.device(), &semaphore, nullptr, &copied);
        if (result != VK_SUCCESS)
            return failed("vkCreateSemaphore", result);
        copied_.push_back(copied);
    }
    width_ = width;
    height_ = height;
    outdated_ = false;
    return Presented::Shown;
}

Result<Presented> Swapchain::present(Image& picture) {
    const Api& api = context_.api();
    if (!swapchain_ || outdated_ || picture.width() != width_ || picture.height() != height_) {
        GLINT_TRY(made, make(picture.width(), picture.height()));
        if (made != Presented::Shown)
            return made;
    }
    uint32_t index = 0;
    VkResult result =
        api.AcquireNextImageKHR(context_.device(), swapchain_, kLongestWait, acquired_, VK_NULL_HANDLE, &index);
    outdated_ = result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR;
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_TIMEOUT || result == VK_NOT_READY)
        return Presented::NotShown;
    if (result == VK_ERROR_SURFACE_LOST_KHR)
        return Presented::SurfaceLost;
    if (result != VK_SUCCESS && result != VK_SUBOPTIMAL_KHR)
        return failed("vkAcquireNextImageKHR", result);
    GLINT_CHECK(copy(picture, index));
    VkPresentInfoKHR info = {VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &copied_[index];
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &index;
    result = api.QueuePresentKHR(context_.queue(), &info);
    outdated_ = outdated_ || result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR;
    if (result == VK_ERROR_SURFACE_LOST_KHR)
        return Presented::SurfaceLost;
    if (result != VK_SUCCESS && result != VK_SUBOPTIMAL_KHR && result != VK_ERROR_OUT_OF_DATE_KHR)
        return failed("vkQueuePresentKHR", result);
    return result == VK_ERROR_OUT_OF_DATE_KHR ? Presented::NotShown : Presented::Shown;
}

/// Not timed, so that the frame's times exclude this last copy.
Result<void> Swapchain::copy(Image& picture, uint32_t index) {
    const Api& api = context_.api();
    api.ResetCommandPool(context_.device(), pool_, 0);
    const VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr,
                                            VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT, nullptr};
    api.BeginCommandBuffer(commands_, &begin);
    Frame frame(context_, commands_);
    Image& target = images_[index];
    target.states().assign(1, justAcquired());
    frame.convert(picture, target);
    frame.hand(target, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR});
    api.EndCommandBuffer(commands_);

    const auto semaphore = [](VkSemaphore handle) {
        VkSemaphoreSubmitInfo info = {VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
        info.semaphore = handle;
        info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        return info;
    };
    const VkSemaphoreSubmitInfo wait = semaphore(acquired_);
    const VkSemaphoreSubmitInfo signal = semaphore(copied_[index]);
    VkCommandBufferSubmitInfo buffer = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.waitSemaphoreInfoCount = submit.signalSemaphoreInfoCount = submit.commandBufferInfoCount = 1;
    submit.pWaitSemaphoreInfos = &wait;
    submit.pSignalSemaphoreInfos = &signal;
    submit.pCommandBufferInfos = &buffer;
    VkResult result = api.QueueSubmit2(context_.queue(), 1, &submit, fence_);
    if (result == VK_SUCCESS)
        result = api.WaitForFences(context_.device(), 1, &fence_, VK_TRUE, UINT64_MAX);
    if (result != VK_SUCCESS)
        return failed("copying the picture into the window", result);
    api.ResetFences(context_.device(), 1, &fence_);
    return {};
}

} // namespace glint::gpu
