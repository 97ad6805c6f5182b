// A Vulkan device as Glint uses it: created by our own programs or adopted from a host. Both use the same type.
#pragma once

#include "base/result.hpp"
#include "gpu/api.hpp"
#include "gpu/device_requirements.hpp"
#include "gpu/shader.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glint::gpu {

namespace vma {
struct VmaAllocator_T; // memory.hpp
}

/// Identity of a physical device, and its support for Glint.
struct DeviceInfo {
    std::string name;
    std::string driver;               ///< name and version as the driver reports them
    std::string apiVersion;           ///< "1.4.305"
    bool software = false;            ///< runs on the CPU
    bool rayQuery = false;            ///< supports VK_KHR_acceleration_structure + VK_KHR_ray_query
    std::vector<std::string> missing; ///< requirements of Glint that the device does not meet; empty: usable
    bool usable() const { return missing.empty(); }
};

struct ContextDesc {
    /// Part of a device name, or an index as `glint devices` prints it; empty: the best usable device.
    std::string device;
    /// Enables the Khronos validation layer with synchronization checks; an error if it is not installed.
    bool validation = false;
    bool rayQuery = true; ///< enables ray queries where the device supports them; false: never
    /// Features to enable; less than Programs makes a device as limited as one of a library's host.
    Demands demands = Demands::Programs;
    /// Instance extensions that the window system requires; empty: no window.
    std::vector<const char*> windowExtensions;
};

/// A host's device. The host owns all handles; they must outlive the context.
struct AdoptedDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    bool rayQuery = false;                          ///< the host enabled rayQueryExtensions() and RayQueryFeatures
    Demands demands = Demands::Sources;             ///< demands whose features the host enabled
    VkPipelineCache pipelineCache = VK_NULL_HANDLE; ///< null: none
    const VkAllocationCallbacks* allocationCallbacks = nullptr; ///< copied; null: the driver's
    void (*message)(void* user, const char* text) = nullptr;    ///< null: none
    void* messageUser = nullptr;
};

enum class SamplerKind : uint8_t { LinearClamp, NearestClamp, LinearRepeat, ShadowCompare, Count };

class Context : public std::enable_shared_from_this<Context> {
public:
    static Result<std::unique_ptr<Context>> create(const ContextDesc& desc);
    static Result<std::unique_ptr<Context>> adopt(const AdoptedDevice& device);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Returns every Vulkan device of this machine. Errors: NotFound if there is no Vulkan loader.
    static Result<std::vector<DeviceInfo>> listDevices();

    /// True if the device is a host's. The host may drop its command buffers or submit them late, so the state of
    /// images and buffers after one recording is not assumed in the next recording (Frame).
    bool adopted() const { return !owned_; }
    uint64_t nextRecording() { return ++recordings_; } ///< Returns a unique number for each command buffer's Frame.

    const Api& api() const { return api_; }
    VkPipelineCache pipelineCache() const { return pipelineCache_; }
    /// For every vkCreate... and vkDestroy... of this device's objects.
    const VkAllocationCallbacks* callbacks() const { return callbacks_ ? &*callbacks_ : nullptr; }
    /// Gives a line to the host's log, if the host asked for it.
    void message(const std::string& text) const {
        if (message_)
            message_(messageUser_, text.c_str());
    }
    const DeviceInfo& info() const { return info_; }
    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
    VkDevice device() const { return device_; }
    /// True if ray queries are enabled: acceleration structures may be built, and shaders may trace rays through them.
    bool rayQuery() const { return rayQuery_; }
    /// True if image tables (gpu/texture_table.hpp) and buffer device addresses are enabled (Demands::Sources).
    bool hasTables() const { return demands_ != Demands::Screen; }
    /// Samplers may use anisotropy; false on a host's device, where it is unknown whether the feature is enabled.
    bool anisotropy() const { return anisotropy_; }
    /// Bytes, for acceleration structure builds; 1 without ray queries.
    uint32_t scratchAlignment() const { return scratchAlignment_; }
    VkDeviceSize maxStorageBufferRange() const { return maxStorageBufferRange_; } ///< bytes that one binding shows
    VkDeviceSize maxBufferSize() const { return maxBufferSize_; }                 ///< bytes
    uint32_t queueFamily() const { return queueFamily_; }
    VkQueueFlags queueFlags() const { return queueFlags_; }
    VkQueue queue() const { return queue_; } ///< the queue of a created context; null for an adopted one
    vma::VmaAllocator_T* allocator() const { return allocator_; }
    double timestampPeriodNs() const { return timestampPeriodNs_; } ///< 0: the queue does not support timestamps
    VkSampler sampler(SamplerKind kind) const { return samplers_[static_cast<size_t>(kind)]; }
    /// Returns the handles that another library needs to adopt this device.
    AdoptedDevice handles() const;

    /// Registers a set of embedded shaders. Sets are static data and stay registered. Registering a set again has no
    /// effect.
    void addShaders(std::span<const EmbeddedShader> shaders);
    /// New pipelines use these shaders in place of the embedded shaders of the same names; existing pipelines do not
    /// change. The replacements must outlive every pipeline.
    void replaceShaders(ShaderReplacements replacements);
    const ShaderReplacements& replacedShaders() const { return replacements_; }
    /// Errors: NotFound, with the nearest name.
    Result<const EmbeddedShader*> findShader(std::string_view name) const;

    /// Records with `recordCommands`, submits and waits. For set-up and headless work only, never while the library
    /// records. Requires a created context. Errors: DeviceLost.
    Result<void> submitAndWait(const std::function<void(VkCommandBuffer)>& recordCommands);

    /// Pipelines made so far, by what they were made from (gpu/pipeline.hpp), and layouts of texture tables, by their
    /// size (gpu/texture_table.hpp). They are kept as long as the context: making a pipeline takes up to seconds on
    /// some drivers, and another Reflections of the host uses the same ones.
    std::map<std::string, std::shared_ptr<void>>& pipelines() { return pipelines_; }
    std::map<uint32_t, VkDescriptorSetLayout>& tableLayouts() { return tableLayouts_; }
    /// What the CompileBatches that live collect (gpu/pipeline.hpp).
    struct Compilation {
        int batches = 0;
        std::vector<std::shared_ptr<void>> waiting;
        std::vector<std::shared_ptr<void>> started; ///< other threads compile these
    };
    Compilation& compilation() { return compilation_; }

    /// What a program keeps as long as the device and destroys before it. Replacing shaders drops it.
    std::shared_ptr<void>& companion() { return companion_; }

    /// Device memory of each image and buffer that exists.
    struct MemoryUse {
        std::string name;
        VkDeviceSize bytes = 0;
    };
    std::map<const void*, MemoryUse>& memoryUses() { return memoryUses_; }

    bool supportsFormat(VkFormat format, VkFormatFeatureFlags2 features) const;
    /// True if an image of this format and usage supports this number of samples per pixel.
    bool supportsSamples(VkFormat format, VkImageUsageFlags usage, uint32_t samples) const;
    void nameObject(VkObjectType type, uint64_t handle, const char* name) const;

    /// Validation messages so far (created contexts with validation enabled). Tests fail if there are any.
    const std::vector<std::string>& validationMessages() const { return validationMessages_; }

private:
    Context() = default;
    Result<void> createInstance(const ContextDesc& desc);
    Result<void> chooseDevice(const ContextDesc& desc);
    Result<void> createDevice(const ContextDesc& desc);
    Result<void> finish();
    Result<void> loadFunctions(); ///< the parts of finish(), in this order
    Result<void> readQueueFamily();
    void readLimits();
    Result<void> createSamplers();
    Result<void> createQueueObjects(); ///< created contexts only
    static VKAPI_ATTR VkBool32 VKAPI_CALL onValidationMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                              VkDebugUtilsMessageTypeFlagsEXT,
                                                              const VkDebugUtilsMessengerCallbackDataEXT*, void*);

    Api api_;
    DeviceInfo info_;
    VkPipelineCache pipelineCache_ = VK_NULL_HANDLE;
    std::optional<VkAllocationCallbacks> callbacks_;
    void (*message_)(void* user, const char* text) = nullptr;
    void* messageUser_ = nullptr;
    void* loader_ = nullptr; ///< gpu/loader.hpp; created contexts only
    bool owned_ = false;
    bool rayQuery_ = false;
    bool anisotropy_ = false;
    Demands demands_ = Demands::Programs;
    bool presents_ = false; ///< created with ContextDesc::windowExtensions
    uint32_t scratchAlignment_ = 1;
    VkDeviceSize maxStorageBufferRange_ = 0;
    VkDeviceSize maxBufferSize_ = 0;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;
    uint64_t recordings_ = 0;
    VkQueueFlags queueFlags_ = 0;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkCommandPool commandPool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    vma::VmaAllocator_T* allocator_ = nullptr;
    double timestampPeriodNs_ = 0;
    VkSampler samplers_[static_cast<size_t>(SamplerKind::Count)] = {};
    std::vector<std::span<const EmbeddedShader>> shaderSets_;
    ShaderReplacements replacements_;
    std::map<std::string, std::shared_ptr<void>> pipelines_;
    Compilation compilation_;
    std::shared_ptr<void> companion_;
    std::map<const void*, MemoryUse> memoryUses_; ///< by allocation
    std::map<uint32_t, VkDescriptorSetLayout> tableLayouts_;
    std::vector<std::string> validationMessages_;
};

/// First base class of objects that a host may destroy after the glint::Context that created them: the device's
/// samplers and allocator are kept until the last such object is destroyed. Has no effect for a context that is not
/// shared, such as those of our programs.
class KeepsContext {
protected:
    explicit KeepsContext(Context& context) : kept_(context.weak_from_this().lock()) {}

private:
    std::shared_ptr<Context> kept_;
};

} // namespace glint::gpu
