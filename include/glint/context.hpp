// SPDX-License-Identifier: MIT
// The host's Vulkan device, which Glint uses but does not own.
#pragma once

#include "glint/api.h"
#include "glint/error.hpp"
#include "glint/version.hpp"

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glint {

namespace gpu {
class Context;
}

/// The parts of Glint that the host uses. They determine the required device features. Vulkan cannot report which
/// features a device was created with, so the host declares the demands.
enum class DeviceDemands : uint8_t {
    Screen,  ///< screen-space reflections, the environment, transparent layers
    Sources, ///< Screen, and probes, planar mirrors and rays
};

/// Receives a message for the host's log: one line of UTF-8, valid during the call. `user`: HostDevice::messageUser.
using MessageCallback = void (*)(void* user, const char* text);

/// The host's Vulkan handles. They must outlive every Glint object created from them: destroy the device last.
struct HostDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0; ///< family of the command buffers that Glint records into; requires compute, not graphics
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    /// True if the host enabled rayQueryExtensions() and the features accelerationStructure and rayQuery. If false,
    /// rays use Glint's own hierarchy (RayBackend::Bvh).
    bool rayQuery = false;
    DeviceDemands demands = DeviceDemands::Sources; ///< the host enabled their features (requireDeviceFeatures)
    /// The host's cache for Glint's pipelines, so that a program's next run need not compile them: the host loads and
    /// stores its data. It must outlive the Context and must not be used by other threads during create calls. Null:
    /// none.
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;
    /// Host memory of every Vulkan object that Glint creates, as Vulkan defines it. The struct is copied. Calls that
    /// create pipelines use it on several threads at once. Null: the driver's own.
    const VkAllocationCallbacks* allocationCallbacks = nullptr;
    /// Receives each note of every Reflections (Reflections::notes) when it is made. Null: none.
    MessageCallback message = nullptr;
    void* messageUser = nullptr;
};

/// Returns the device extensions that the host must enable in addition to Vulkan 1.3.
GLINT_API std::span<const char* const> requiredDeviceExtensions();

/// Returns the additional device extensions that ray queries require. Optional (HostDevice::rayQuery).
GLINT_API std::span<const char* const> rayQueryExtensions();

/// Enables every feature that Glint requires in the structs that the host will create its device with.
/// A null struct is skipped: the host then enables its features itself (docs/embedding.md has the list).
GLINT_API void requireDeviceFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                                     VkPhysicalDeviceVulkan13Features* v13,
                                     DeviceDemands demands = DeviceDemands::Sources);

/// Device memory of all images and buffers of one name.
struct MemoryUse {
    std::string name;
    uint64_t bytes = 0;
    uint32_t count = 0;
};

/// Device memory that the objects made from one Context use.
struct MemoryReport {
    std::vector<MemoryUse> uses; ///< the largest first
    uint64_t bytes = 0;          ///< of all images and buffers
    uint64_t taken = 0;          ///< of the driver, in blocks that images and buffers share
};

/// Glint on one device. A Context has its own dispatch table and memory allocator and uses no global state, so several
/// contexts can coexist, with any Vulkan loader. Objects created from a Context share ownership of its internals, so
/// the Context and these objects may be destroyed in any order. Threading: external synchronization.
class GLINT_API Context {
public:
    /// Creates a Context on the host's device.
    /// `headerVersion`  version of the headers that the host was compiled with: leave the default
    /// Errors: InvalidArgument for a null handle, a queue family that does not exist or lacks compute, `rayQuery` with
    /// DeviceDemands::Screen, or headers whose version does not fit this library. Unsupported, with the missing
    /// feature, for a device that does not support `demands`, or that does not have ray queries enabled although
    /// `rayQuery` is set.
    static Result<Context> adopt(const HostDevice& device, uint32_t headerVersion = GLINT_VERSION);
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    const std::string& deviceName() const;
    const std::string& driver() const;

    /// Returns the memory in use now, also by objects that wait for the GPU before they are freed.
    MemoryReport memory() const;

    gpu::Context& gpu() { return *gpu_; } ///< for Glint's own classes

private:
    explicit Context(std::shared_ptr<gpu::Context> context);
    std::shared_ptr<gpu::Context> gpu_;
};

} // namespace glint
