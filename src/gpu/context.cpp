#include "gpu/context.hpp"

#include "base/text.hpp"
#include "gpu/device_requirements.hpp"
#include "gpu/loader.hpp"
#include "gpu/memory.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <mutex>
#include <optional>

namespace glint::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

Error vulkanError(const char* what, VkResult result) {
    const ErrorCode code = result == VK_ERROR_DEVICE_LOST            ? ErrorCode::DeviceLost
                           : result == VK_ERROR_OUT_OF_DEVICE_MEMORY ? ErrorCode::OutOfMemory
                                                                     : ErrorCode::Unsupported;
    return makeError(code, "{} failed with VkResult {}", what, static_cast<int>(result));
}

DeviceInfo describe(const Api& api, VkPhysicalDevice device, Demands demands) {
    VkPhysicalDeviceDriverProperties driver = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver};
    api.GetPhysicalDeviceProperties2(device, &properties);
    const uint32_t version = properties.properties.apiVersion;
    DeviceInfo info;
    info.name = properties.properties.deviceName;
    info.driver = formatText("{} {}", driver.driverName, driver.driverInfo);
    info.apiVersion = formatText("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                                 VK_API_VERSION_PATCH(version));
    info.software = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    info.missing = missingRequirements(api, device, demands);
    info.rayQuery = version >= VK_API_VERSION_1_2 && supportsRayQuery(api, device);
    return info;
}

std::vector<VkPhysicalDevice> physicalDevices(const Api& api, VkInstance instance) {
    uint32_t count = 0;
    if (api.EnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS)
        return {};
    std::vector<VkPhysicalDevice> devices(count);
    api.EnumeratePhysicalDevices(instance, &count, devices.data());
    return devices;
}

/// Glint uses one queue for whole frames, which include the draws of our programs.
std::optional<uint32_t> findQueueFamily(const Api& api, VkPhysicalDevice device, Demands demands) {
    uint32_t count = 0;
    api.GetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    api.GetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    const VkQueueFlags needed =
        VK_QUEUE_COMPUTE_BIT | (demands == Demands::Programs ? VkQueueFlags(VK_QUEUE_GRAPHICS_BIT) : 0);
    for (uint32_t i = 0; i < count; ++i)
        if ((families[i].queueFlags & needed) == needed)
            return i;
    return std::nullopt;
}

bool containsIgnoringCase(std::string_view text, std::string_view part) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::search(text.begin(), text.end(), part.begin(), part.end(),
                       [&](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

} // namespace

Result<std::unique_ptr<Context>> Context::create(const ContextDesc& desc) {
    std::unique_ptr<Context> context(new Context);
    context->owned_ = true;
    GLINT_CHECK(context->createInstance(desc));
    GLINT_CHECK(context->chooseDevice(desc));
    GLINT_CHECK(context->createDevice(desc));
    GLINT_CHECK(context->finish());
    return context;
}

Result<std::unique_ptr<Context>> Context::adopt(const AdoptedDevice& host) {
    if (!host.instance || !host.physicalDevice || !host.device || !host.getInstanceProcAddr)
        return invalidArgument("a host's device needs instance, physicalDevice, device and getInstanceProcAddr");
    std::unique_ptr<Context> context(new Context);
    context->instance_ = host.instance;
    context->physicalDevice_ = host.physicalDevice;
    context->device_ = host.device;
    context->queueFamily_ = host.queueFamily;
    context->api_.loadInstance(host.getInstanceProcAddr, host.instance);
    context->demands_ = host.demands;
    context->info_ = describe(context->api_, host.physicalDevice, host.demands);
    if (host.rayQuery && host.demands == Demands::Screen)
        return invalidArgument("ray queries on a device that was made for the screen's reflections alone");
    context->rayQuery_ = host.rayQuery;
    context->pipelineCache_ = host.pipelineCache;
    if (host.allocationCallbacks)
        context->callbacks_ = *host.allocationCallbacks;
    context->message_ = host.message;
    context->messageUser_ = host.messageUser;
    GLINT_CHECK(context->finish());
    return context;
}

Result<void> Context::createInstance(const ContextDesc& desc) {
    GLINT_TRY(loader, openLoader());
    loader_ = loader;
    const PFN_vkGetInstanceProcAddr getInstanceProcAddr = instanceProcAddr(loader_);
    const auto createInstance =
        reinterpret_cast<PFN_vkCreateInstance>(getInstanceProcAddr(nullptr, "vkCreateInstance"));
    const auto enumerateExtensions = reinterpret_cast<PFN_vkEnumerateInstanceExtensionProperties>(
        getInstanceProcAddr(nullptr, "vkEnumerateInstanceExtensionProperties"));

    uint32_t count = 0;
    enumerateExtensions(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> available(count);
    enumerateExtensions(nullptr, &count, available.data());
    const bool debugUtils = std::any_of(available.begin(), available.end(), [](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) == 0;
    });

    std::vector<const char*> extensions;
    if (debugUtils)
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    extensions.insert(extensions.end(), desc.windowExtensions.begin(), desc.windowExtensions.end());
    const VkApplicationInfo application = {
        VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "glint", 1, "glint", 1, VK_API_VERSION_1_3};
    const VkValidationFeatureEnableEXT enable = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT features = {
        VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, nullptr, 1, &enable, 0, nullptr};
    VkDebugUtilsMessengerCreateInfoEXT messenger = {VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    messenger.pNext = &features;
    messenger.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    messenger.pfnUserCallback = &Context::onValidationMessage;
    messenger.pUserData = this;

    VkInstanceCreateInfo info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pApplicationInfo = &application;
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (desc.validation) {
        info.pNext = &messenger;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &kValidationLayer;
    }
    const VkResult result = createInstance(&info, nullptr, &instance_);
    if (result == VK_ERROR_LAYER_NOT_PRESENT)
        return makeError(ErrorCode::Unsupported, "{} is not installed (package vulkan-validationlayers)",
                         kValidationLayer);
    if (result == VK_ERROR_EXTENSION_NOT_PRESENT)
        return makeError(ErrorCode::Unsupported, "the Vulkan driver cannot show windows here ({} is missing)",
                         joinText(std::vector<std::string>(extensions.begin(), extensions.end()), " or "));
    if (result != VK_SUCCESS)
        return makeError(ErrorCode::Unsupported,
                         "no Vulkan driver answers (vkCreateInstance: VkResult {}); "
                         "start the program with scripts/glint",
                         static_cast<int>(result));
    api_.loadInstance(getInstanceProcAddr, instance_);
    if (desc.validation) {
        messenger.pNext = nullptr;
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            getInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
        if (!create || create(instance_, &messenger, nullptr, &messenger_) != VK_SUCCESS)
            return makeError(ErrorCode::Unsupported, "validation messages cannot be received (VK_EXT_debug_utils)");
    }
    return {};
}

VkBool32 Context::onValidationMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    static std::mutex oneAtATime; // pipelines compile on several threads
    const std::lock_guard lock(oneAtATime);
    static_cast<Context*>(user)->validationMessages_.emplace_back(data->pMessage);
    return VK_FALSE;
}

Result<std::vector<DeviceInfo>> Context::listDevices() {
    Context context;
    context.owned_ = true;
    GLINT_CHECK(context.createInstance({}));
    std::vector<DeviceInfo> list;
    for (VkPhysicalDevice device : physicalDevices(context.api_, context.instance_))
        list.push_back(describe(context.api_, device, Demands::Programs));
    return list;
}

Result<void> Context::chooseDevice(const ContextDesc& desc) {
    const std::vector<VkPhysicalDevice> devices = physicalDevices(api_, instance_);
    if (devices.empty())
        return makeError(ErrorCode::NotFound, "no Vulkan device on this machine; start the program with scripts/glint");

    std::vector<DeviceInfo> infos;
    for (VkPhysicalDevice device : devices)
        infos.push_back(describe(api_, device, desc.demands));
    std::optional<size_t> chosen;
    if (!desc.device.empty()) {
        size_t index = 0;
        const char* end = desc.device.data() + desc.device.size();
        if (const auto parsed = std::from_chars(desc.device.data(), end, index); parsed.ptr == end) {
            if (index < devices.size())
                chosen = index;
        } else {
            for (size_t i = 0; i < infos.size() && !chosen; ++i)
                if (containsIgnoringCase(infos[i].name, desc.device))
                    chosen = i;
        }
        if (!chosen) {
            std::string names;
            for (size_t i = 0; i < infos.size(); ++i)
                names += formatText("{}{}: {}", i ? ", " : "", i, infos[i].name);
            return makeError(ErrorCode::NotFound, "no device '{}'; this machine has {}", desc.device, names);
        }
    } else {
        // Hardware devices before software devices; in each group in the driver's order.
        for (const bool software : {false, true})
            for (size_t i = 0; i < infos.size() && !chosen; ++i)
                if (infos[i].usable() && infos[i].software == software)
                    chosen = i;
        if (!chosen)
            chosen = 0; // its missing requirements are reported below
    }
    info_ = infos[*chosen];
    physicalDevice_ = devices[*chosen];
    if (!info_.usable())
        return makeError(ErrorCode::Unsupported, "{} cannot run Glint: it lacks {}", info_.name,
                         joinText(info_.missing, ", "));
    return {};
}

Result<void> Context::createDevice(const ContextDesc& desc) {
    const std::optional<uint32_t> family = findQueueFamily(api_, physicalDevice_, desc.demands);
    if (!family)
        return makeError(ErrorCode::Unsupported, "{} has no queue that {}", info_.name,
                         desc.demands == Demands::Programs ? "both draws and computes" : "computes");
    queueFamily_ = *family;
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue = {
        VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, queueFamily_, 1, &priority};
    FeatureChain features;
    requireFeatures(desc.demands, &features.base.features, &features.v12, &features.v13);
    VkPhysicalDeviceFeatures2 available = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    api_.GetPhysicalDeviceFeatures2(physicalDevice_, &available);
    anisotropy_ = desc.demands == Demands::Programs && available.features.samplerAnisotropy == VK_TRUE;
    features.base.features.samplerAnisotropy = anisotropy_ ? VK_TRUE : VK_FALSE;
    demands_ = desc.demands;
    VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.base};
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    std::vector<const char*> extensions = requiredDeviceExtensions();
    RayQueryFeatures rays;
    rayQuery_ = desc.rayQuery && info_.rayQuery;
    if (rayQuery_) {
        extensions.insert(extensions.end(), rayQueryExtensions().begin(), rayQueryExtensions().end());
        rays.require();
        features.v13.pNext = &rays.accelerationStructure;
    }
    presents_ = !desc.windowExtensions.empty();
    if (presents_ && !hasExtension(api_, physicalDevice_, VK_KHR_SWAPCHAIN_EXTENSION_NAME))
        return makeError(ErrorCode::Unsupported, "{} cannot show pictures in a window (no VK_KHR_swapchain)",
                         info_.name);
    if (presents_)
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    if (const VkResult result = api_.CreateDevice(physicalDevice_, &info, nullptr, &device_); result != VK_SUCCESS)
        return vulkanError("vkCreateDevice", result);
    return {};
}

Result<void> Context::finish() {
    GLINT_CHECK(loadFunctions());
    GLINT_CHECK(readQueueFamily());
    readLimits();
    if (const VkResult result =
            createAllocator(api_, instance_, physicalDevice_, device_, hasTables(), callbacks(), allocator_);
        result != VK_SUCCESS)
        return vulkanError("creating the memory allocator", result);
    GLINT_CHECK(createSamplers());
    return owned_ ? createQueueObjects() : Result<void>();
}

Result<void> Context::loadFunctions() {
    api_.loadDevice(device_);
    // The device returns these functions even if the extension is not enabled; the instance does not.
    if (!api_.GetInstanceProcAddr(instance_, "vkSetDebugUtilsObjectNameEXT")) {
        api_.SetDebugUtilsObjectNameEXT = nullptr;
        api_.CmdBeginDebugUtilsLabelEXT = nullptr;
        api_.CmdEndDebugUtilsLabelEXT = nullptr;
    }
    if (const char* missing = api_.firstMissing())
        return makeError(ErrorCode::Unsupported,
                         "the device does not offer {}: it needs Vulkan 1.3 and VK_KHR_push_descriptor enabled",
                         missing);

    if (const char* missing = api_.firstMissingForWindows(); presents_ && missing)
        return makeError(ErrorCode::Unsupported, "the device does not offer {}", missing);
    if (const char* missing = api_.firstMissingForRays(); rayQuery_ && missing)
        return makeError(ErrorCode::Unsupported, "ray queries are not enabled on the device: it does not offer {}",
                         missing);
    return {};
}

Result<void> Context::readQueueFamily() {
    uint32_t count = 0;
    api_.GetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    api_.GetPhysicalDeviceQueueFamilyProperties(physicalDevice_, &count, families.data());
    if (queueFamily_ >= count)
        return invalidArgument("queue family {} is not one of the device's {}", queueFamily_, count);
    queueFlags_ = families[queueFamily_].queueFlags;
    if ((queueFlags_ & VK_QUEUE_COMPUTE_BIT) == 0)
        return invalidArgument("queue family {} does not compute", queueFamily_);
    if (families[queueFamily_].timestampValidBits > 0) {
        VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
        api_.GetPhysicalDeviceProperties2(physicalDevice_, &properties);
        timestampPeriodNs_ = static_cast<double>(properties.properties.limits.timestampPeriod);
    }
    return {};
}

void Context::readLimits() {
    VkPhysicalDeviceVulkan13Properties v13 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};
    VkPhysicalDeviceVulkan11Properties v11 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES, &v13};
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &v11};
    api_.GetPhysicalDeviceProperties2(physicalDevice_, &properties);
    maxStorageBufferRange_ = properties.properties.limits.maxStorageBufferRange;
    maxBufferSize_ = std::min(v13.maxBufferSize, v11.maxMemoryAllocationSize);
    if (!rayQuery_)
        return;
    VkPhysicalDeviceAccelerationStructurePropertiesKHR structures = {
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
    properties.pNext = &structures;
    api_.GetPhysicalDeviceProperties2(physicalDevice_, &properties);
    scratchAlignment_ = std::max(structures.minAccelerationStructureScratchOffsetAlignment, 1u);
}

Result<void> Context::createSamplers() {
    for (size_t i = 0; i < static_cast<size_t>(SamplerKind::Count); ++i) {
        const auto kind = static_cast<SamplerKind>(i);
        VkSamplerCreateInfo info = {VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
        const bool linear = kind != SamplerKind::NearestClamp;
        info.magFilter = info.minFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
        info.mipmapMode = linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
        info.addressModeU = info.addressModeV = info.addressModeW =
            kind == SamplerKind::LinearRepeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        info.maxLod = VK_LOD_CLAMP_NONE;
        if (kind == SamplerKind::ShadowCompare) {
            info.compareEnable = VK_TRUE;
            info.compareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; // reversed depth: lit if no occluder is nearer
        }
        if (const VkResult result = api_.CreateSampler(device_, &info, callbacks(), &samplers_[i]);
            result != VK_SUCCESS)
            return vulkanError("vkCreateSampler", result);
    }
    return {};
}

Result<void> Context::createQueueObjects() {
    api_.GetDeviceQueue(device_, queueFamily_, 0, &queue_);
    const VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0, queueFamily_};
    const VkFenceCreateInfo fence = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    VkResult result = api_.CreateCommandPool(device_, &pool, nullptr, &commandPool_);
    if (result == VK_SUCCESS) {
        const VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr,
                                                      commandPool_, VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
        result = api_.AllocateCommandBuffers(device_, &allocate, &commands_);
    }
    if (result == VK_SUCCESS)
        result = api_.CreateFence(device_, &fence, nullptr, &fence_);
    if (result != VK_SUCCESS)
        return vulkanError("creating the command pool", result);
    nameObject(VK_OBJECT_TYPE_COMMAND_POOL, reinterpret_cast<uint64_t>(commandPool_), "glint/commands");
    nameObject(VK_OBJECT_TYPE_FENCE, reinterpret_cast<uint64_t>(fence_), "glint/submitted");
    return {};
}

Context::~Context() {
    companion_.reset();
    pipelines_.clear();
    for (const auto& [size, layout] : tableLayouts_)
        api_.DestroyDescriptorSetLayout(device_, layout, callbacks());
    if (device_ && api_.DestroySampler)
        for (VkSampler sampler : samplers_)
            api_.DestroySampler(device_, sampler, callbacks());
    if (allocator_)
        destroyAllocator(allocator_);
    if (owned_) {
        if (fence_)
            api_.DestroyFence(device_, fence_, nullptr);
        if (commandPool_)
            api_.DestroyCommandPool(device_, commandPool_, nullptr);
        if (device_ && api_.DestroyDevice)
            api_.DestroyDevice(device_, nullptr);
        if (messenger_) {
            const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
                api_.GetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
            destroy(instance_, messenger_, nullptr);
        }
        if (instance_)
            api_.DestroyInstance(instance_, nullptr);
        if (loader_)
            closeLoader(loader_);
    }
}

AdoptedDevice Context::handles() const {
    return {instance_, physicalDevice_, device_, queueFamily_, api_.GetInstanceProcAddr, rayQuery_, demands_};
}

void Context::replaceShaders(ShaderReplacements replacements) {
    replacements_ = std::move(replacements);
    companion_.reset();
    pipelines_.clear(); // they are known by their shaders' addresses, which a later replacement may receive again
}

void Context::addShaders(std::span<const EmbeddedShader> shaders) {
    const bool known = std::any_of(shaderSets_.begin(), shaderSets_.end(),
                                   [&](const auto& set) { return set.data() == shaders.data(); });
    if (!known)
        shaderSets_.push_back(shaders);
}

Result<const EmbeddedShader*> Context::findShader(std::string_view name) const {
    std::vector<std::string_view> names;
    for (const auto& set : shaderSets_)
        for (const EmbeddedShader& shader : set) {
            if (shader.name == name) {
                const auto replaced = replacements_.find(name);
                return replaced == replacements_.end() ? &shader : replaced->second;
            }
            names.push_back(shader.name);
        }
    return makeError(ErrorCode::NotFound, "no shader '{}'; the nearest name is '{}'", name, nearestText(name, names));
}

Result<void> Context::submitAndWait(const std::function<void(VkCommandBuffer)>& recordCommands) {
    api_.ResetCommandPool(device_, commandPool_, 0);
    const VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr,
                                            VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT, nullptr};
    api_.BeginCommandBuffer(commands_, &begin);
    recordCommands(commands_);
    if (const VkResult result = api_.EndCommandBuffer(commands_); result != VK_SUCCESS)
        return vulkanError("vkEndCommandBuffer", result);
    VkCommandBufferSubmitInfo buffer = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    VkResult result = api_.QueueSubmit2(queue_, 1, &submit, fence_);
    if (result == VK_SUCCESS)
        result = api_.WaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX);
    if (result != VK_SUCCESS)
        return vulkanError("running commands on the GPU", result);
    api_.ResetFences(device_, 1, &fence_);
    return {};
}

bool Context::supportsFormat(VkFormat format, VkFormatFeatureFlags2 features) const {
    VkFormatProperties3 properties3 = {VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3};
    VkFormatProperties2 properties = {VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2, &properties3};
    api_.GetPhysicalDeviceFormatProperties2(physicalDevice_, format, &properties);
    return (properties3.optimalTilingFeatures & features) == features;
}

bool Context::supportsSamples(VkFormat format, VkImageUsageFlags usage, uint32_t samples) const {
    VkPhysicalDeviceImageFormatInfo2 info = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2};
    info.format = format;
    info.type = VK_IMAGE_TYPE_2D;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    VkImageFormatProperties2 properties = {VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2};
    return api_.GetPhysicalDeviceImageFormatProperties2(physicalDevice_, &info, &properties) == VK_SUCCESS &&
           (properties.imageFormatProperties.sampleCounts & samples) != 0;
}

void Context::nameObject(VkObjectType type, uint64_t handle, const char* name) const {
    if (!api_.SetDebugUtilsObjectNameEXT)
        return;
    const VkDebugUtilsObjectNameInfoEXT info = {VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT, nullptr, type,
                                                handle, name};
    api_.SetDebugUtilsObjectNameEXT(device_, &info);
}

} // namespace glint::gpu
