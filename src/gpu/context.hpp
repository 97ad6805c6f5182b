// A Vulkan device as Glint uses it: created by our own programs, or adopted from a host. One type for both.
#pragma once

#include "base/result.hpp"
#include "gpu/api.hpp"
#include "gpu/shader.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glint::gpu {

namespace vma {
struct VmaAllocator_T; // memory.hpp
}

/// What a physical device is and what it can do for Glint.
struct DeviceInfo {
    std::string name;
    std::string driver;               ///< name and version as the driver says them
    std::string apiVersion;           ///< "1.4.305"
    bool software = false;            ///< runs on the CPU
    bool rayQuery = false;            ///< offers VK_KHR_acceleration_structure + VK_KHR_ray_query
    std::vector<std::string> missing; ///< what Glint needs and this device lacks; empty: usable
    bool usable() const { return missing.empty(); }
};

struct ContextDesc {
    std::string device;      ///< part of a name, or an index as `glint devices` prints it; empty: the best usable one
    bool validation = false; ///< the Khronos layer with synchronization checks; an error if it is not installed
    bool rayQuery = true;    ///< enabled where the device offers it; false leaves it off everywhere
    std::vector<const char*> windowExtensions; ///< of the instance, as the window system needs them; empty: no window
};

/// A host's device. All handles stay the host's; they must outlive the context.
struct AdoptedDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    bool rayQuery = false; ///< the host enabled rayQueryExtensions() and RayQueryFeatures
};

enum class SamplerKind : uint8_t { LinearClamp, NearestClamp, LinearRepeat, ShadowCompare, Count };

class Context {
public:
    static Result<std::unique_ptr<Context>> create(const ContextDesc& desc);
    static Result<std::unique_ptr<Context>> adopt(const AdoptedDevice& device);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Every Vulkan device of this machine. Errors: NotFound when there is no Vulkan loader.
    static Result<std::vector<DeviceInfo>> listDevices();

    const Api& api() const { return api_; }
    const DeviceInfo& info() const { return info_; }
    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
    VkDevice device() const { return device_; }
    /// Enabled on this device: acceleration structures may be built and shaders may trace through them.
    bool rayQuery() const { return rayQuery_; }
    uint32_t scratchAlignment() const { return scratchAlignment_; } ///< bytes; of builds, 1 without ray queries
    VkDeviceSize maxStorageBufferRange() const { return maxStorageBufferRange_; } ///< bytes
    uint32_t queueFamily() const { return queueFamily_; }
    VkQueue queue() const { return queue_; } ///< of a created context; null of an adopted one
    vma::VmaAllocator_T* allocator() const { return allocator_; }
    double timestampPeriodNs() const { return timestampPeriodNs_; } ///< 0: the queue has no timestamps
    VkSampler sampler(SamplerKind kind) const { return samplers_[static_cast<size_t>(kind)]; }
    /// The handles that another library needs to adopt this device.
    AdoptedDevice handles() const;

    /// Makes a set of embedded shaders known; sets are static data and stay known for good. Saying it twice
    /// does no harm.
    void addShaders(std::span<const EmbeddedShader> shaders);
    /// From here on pipelines are made of these where they bear an embedded shader's name; those that are there stay as
    /// they are. They must outlive every pipeline, and another text is another object: by it pipelines are shared.
    void replaceShaders(ShaderReplacements replacements) { replacements_ = std::move(replacements); }
    const ShaderReplacements& replacedShaders() const { return replacements_; }
    /// Errors: NotFound, with the nearest name.
    Result<const EmbeddedShader*> findShader(std::string_view name) const;

    /// Records with `recordCommands`, submits and waits: for set-up and headless work, never inside a library's record.
    /// Only for a created context. Errors: DeviceLost.
    Result<void> submitAndWait(const std::function<void(VkCommandBuffer)>& recordCommands);

    /// Compute pipelines that somebody still has (gpu/pipeline.hpp), by what they were made from.
    std::map<std::string, std::weak_ptr<void>>& pipelines() { return pipelines_; }

    bool supportsFormat(VkFormat format, VkFormatFeatureFlags2 features) const;
    /// Can an image of this format and usage have so many samples a pixel?
    bool supportsSamples(VkFormat format, VkImageUsageFlags usage, uint32_t samples) const;
    void nameObject(VkObjectType type, uint64_t handle, const char* name) const;

    /// Made with ContextDesc::windowExtensions: gpu/swapchain.hpp can show pictures.
    bool presents() const { return presents_; }
    /// Validation messages so far (created contexts with validation on). Tests fail on any.
    const std::vector<std::string>& validationMessages() const { return validationMessages_; }

private:
    Context() = default;
    Result<void> createInstance(const ContextDesc& desc);
    Result<void> chooseDevice(const ContextDesc& desc);
    Result<void> createDevice(const ContextDesc& desc);
    Result<void> finish();
    static VKAPI_ATTR VkBool32 VKAPI_CALL onValidationMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                              VkDebugUtilsMessageTypeFlagsEXT,
                                                              const VkDebugUtilsMessengerCallbackDataEXT*, void*);

    Api api_;
    DeviceInfo info_;
    void* loader_ = nullptr; ///< dlopen handle, created contexts only
    bool owned_ = false;
    bool rayQuery_ = false;
    bool presents_ = false;
    uint32_t scratchAlignment_ = 1;
    VkDeviceSize maxStorageBufferRange_ = 0;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool commandPool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    vma::VmaAllocator_T* allocator_ = nullptr;
    double timestampPeriodNs_ = 0;
    VkSampler samplers_[static_cast<size_t>(SamplerKind::Count)] = {};
    std::vector<std::span<const EmbeddedShader>> shaderSets_;
    ShaderReplacements replacements_;
    std::map<std::string, std::weak_ptr<void>> pipelines_;
    std::vector<std::string> validationMessages_;
};

} // namespace glint::gpu
