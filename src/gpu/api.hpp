// Every Vulkan function that Glint calls, in one table per context. Nothing is linked and nothing is global, so that a
// host may use any loader of its own (volk, Vulkan-Hpp).
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#include <vulkan/vulkan.h>

// clang-format off
#define GLINT_VK_INSTANCE_FUNCTIONS(X)                                                                                 \
    X(DestroyInstance) X(EnumeratePhysicalDevices) X(GetPhysicalDeviceProperties2) X(GetPhysicalDeviceFeatures2)       \
    X(GetPhysicalDeviceFormatProperties2) X(GetPhysicalDeviceImageFormatProperties2)                                   \
    X(GetPhysicalDeviceQueueFamilyProperties)                                                                          \
    X(GetPhysicalDeviceMemoryProperties) X(EnumerateDeviceExtensionProperties) X(CreateDevice) X(GetDeviceProcAddr)

#define GLINT_VK_DEVICE_FUNCTIONS(X)                                                                                   \
    X(DestroyDevice) X(GetDeviceQueue) X(DeviceWaitIdle) X(QueueSubmit2) X(QueueWaitIdle)                              \
    X(CreateCommandPool) X(DestroyCommandPool) X(ResetCommandPool) X(AllocateCommandBuffers)                           \
    X(BeginCommandBuffer) X(EndCommandBuffer) X(CreateFence) X(DestroyFence) X(WaitForFences) X(ResetFences)           \
    X(CreateImageView) X(DestroyImageView) X(CreateSampler) X(DestroySampler)                                          \
    X(CreateShaderModule) X(DestroyShaderModule) X(CreatePipelineLayout) X(DestroyPipelineLayout)                      \
    X(CreateComputePipelines) X(CreateGraphicsPipelines) X(DestroyPipeline)                                            \
    X(CreateDescriptorSetLayout) X(DestroyDescriptorSetLayout) X(CreateDescriptorPool) X(DestroyDescriptorPool)        \
    X(AllocateDescriptorSets) X(UpdateDescriptorSets) X(CreateQueryPool) X(DestroyQueryPool)                           \
    X(CmdPipelineBarrier2) X(CmdBindPipeline) X(CmdBindDescriptorSets) X(CmdPushDescriptorSetKHR) X(CmdPushConstants)  \
    X(CmdDispatch) X(CmdDispatchIndirect) X(CmdBeginRendering) X(CmdEndRendering) X(CmdSetViewport) X(CmdSetScissor)   \
    X(CmdSetCullMode) X(CmdSetFrontFace)                                                                               \
    X(CmdBindIndexBuffer) X(CmdDraw) X(CmdDrawIndexed) X(CmdCopyBuffer) X(CmdCopyImage) X(CmdBlitImage)                \
    X(CmdResolveImage)                                                                                                 \
    X(CmdCopyBufferToImage) X(CmdCopyImageToBuffer) X(CmdUpdateBuffer) X(CmdFillBuffer) X(CmdClearColorImage)          \
    X(CmdResetQueryPool) X(CmdWriteTimestamp2) X(CmdCopyQueryPoolResults)

/// Present only where VK_EXT_debug_utils is enabled; null otherwise.
#define GLINT_VK_DEBUG_FUNCTIONS(X)                                                                                    \
    X(SetDebugUtilsObjectNameEXT) X(CmdBeginDebugUtilsLabelEXT) X(CmdEndDebugUtilsLabelEXT)

/// Present only where ray queries are enabled (Context::rayQuery); otherwise never called.
#define GLINT_VK_RAY_FUNCTIONS(X)                                                                                      \
    X(CreateAccelerationStructureKHR) X(DestroyAccelerationStructureKHR) X(GetAccelerationStructureBuildSizesKHR)      \
    X(GetAccelerationStructureDeviceAddressKHR) X(CmdBuildAccelerationStructuresKHR) X(GetBufferDeviceAddress)

/// Present only where the context can present to a window (ContextDesc::windowExtensions); otherwise never called.
#define GLINT_VK_SURFACE_FUNCTIONS(X)                                                                                  \
    X(DestroySurfaceKHR) X(GetPhysicalDeviceSurfaceSupportKHR) X(GetPhysicalDeviceSurfaceCapabilitiesKHR)              \
    X(GetPhysicalDeviceSurfaceFormatsKHR)
#define GLINT_VK_SWAPCHAIN_FUNCTIONS(X)                                                                                \
    X(CreateSwapchainKHR) X(DestroySwapchainKHR) X(GetSwapchainImagesKHR) X(AcquireNextImageKHR) X(QueuePresentKHR)    \
    X(CreateSemaphore) X(DestroySemaphore)
// clang-format on

namespace glint::gpu {

struct Api {
    PFN_vkGetInstanceProcAddr GetInstanceProcAddr = nullptr;
#define GLINT_VK_MEMBER(name) PFN_vk##name name = nullptr;
    GLINT_VK_INSTANCE_FUNCTIONS(GLINT_VK_MEMBER)
    GLINT_VK_DEVICE_FUNCTIONS(GLINT_VK_MEMBER)
    GLINT_VK_DEBUG_FUNCTIONS(GLINT_VK_MEMBER)
    GLINT_VK_RAY_FUNCTIONS(GLINT_VK_MEMBER)
    GLINT_VK_SURFACE_FUNCTIONS(GLINT_VK_MEMBER)
    GLINT_VK_SWAPCHAIN_FUNCTIONS(GLINT_VK_MEMBER)
#undef GLINT_VK_MEMBER

    void loadInstance(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance);
    void loadDevice(VkDevice device);
    /// Returns the name of the first required function that the device does not provide; null if all are present.
    /// Functions of an extension that was not enabled count as missing.
    const char* firstMissing() const;
    const char* firstMissingForRays() const;
    const char* firstMissingForWindows() const;
};

} // namespace glint::gpu
