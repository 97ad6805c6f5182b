// A host's Vulkan device, as Glint borrows it.
#pragma once

#include "glint/api.hpp"
#include "glint/error.hpp"

#include <vulkan/vulkan_core.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glint {

namespace gpu {
class Context;
}

/// The host's own handles. They must outlive every Glint object made from them.
struct HostDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0; ///< that of the command buffers given to Glint; it must draw and compute
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    /// The host enabled rayQueryExtensions() and the features accelerationStructure and rayQuery. Without them rays go
    /// through Glint's own hierarchy (RayBackend::Bvh).
    bool rayQuery = false;
};

/// Device extensions that the host must have enabled, besides Vulkan 1.3.
GLINT_API std::span<const char* const> requiredDeviceExtensions();

/// Device extensions that ray queries need besides; optional (HostDevice::rayQuery).
GLINT_API std::span<const char* const> rayQueryExtensions();

/// Switches on, in the structs that the host is about to create its device with, every feature that Glint needs.
/// A null struct is skipped: then the host switches those on itself (docs/embedding.md has the list).
GLINT_API void requireDeviceFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                                     VkPhysicalDeviceVulkan13Features* v13);

/// Glint on one device. It keeps a dispatch table and a memory allocator of its own and touches no global state, so
/// several may live side by side, and any loader may be used beside them. Threading: external synchronisation.
class GLINT_API Context {
public:
    /// Errors: InvalidArgument for a null handle or a queue family that is not there; Unsupported, with what is
    /// missing, for a device that cannot run Glint, or that has not enabled the ray queries it is said to have.
    static Result<Context> adopt(const HostDevice& device);
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    const std::string& deviceName() const;
    const std::string& driver() const;

    gpu::Context& gpu() { return *gpu_; } ///< for Glint's own classes

private:
    explicit Context(std::unique_ptr<gpu::Context> context);
    std::unique_ptr<gpu::Context> gpu_;
};

} // namespace glint
