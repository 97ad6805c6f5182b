#include "glint/context.hpp"

#include "base/text.hpp"
#include "gpu/context.hpp"
#include "gpu/device_requirements.hpp"
#include "gpu/memory.hpp"

#include <algorithm>

namespace glint {

namespace {

gpu::Demands toDemands(DeviceDemands demands) {
    return demands == DeviceDemands::Screen ? gpu::Demands::Screen : gpu::Demands::Sources;
}

std::string versionText(uint32_t version) {
    return formatText("{}.{}.{}", version / 1000000, version / 1000 % 1000, version % 1000);
}

/// Layouts of structs may differ between minor versions, so no struct is read before this check. The version arrives
/// in an argument of its own, which the host's compiler fills in.
Result<void> checkHeaders(uint32_t headerVersion) {
    if (headerVersion / 1000 == GLINT_VERSION / 1000)
        return {};
    return invalidArgument("the host was compiled with the headers of Glint {}, but runs with the library of Glint {}: "
                           "compile it again with the headers of this library",
                           versionText(headerVersion), versionText(GLINT_VERSION));
}

} // namespace

std::span<const char* const> requiredDeviceExtensions() {
    return gpu::requiredDeviceExtensions();
}

std::span<const char* const> rayQueryExtensions() {
    return gpu::rayQueryExtensions();
}

void requireDeviceFeatures(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                           VkPhysicalDeviceVulkan13Features* v13, DeviceDemands demands) {
    gpu::requireFeatures(toDemands(demands), core, v12, v13);
}

uint32_t version() {
    return GLINT_VERSION;
}

Context::Context(std::shared_ptr<gpu::Context> context) : gpu_(std::move(context)) {}
Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

Result<Context> Context::adopt(const HostDevice& device, uint32_t headerVersion) {
    GLINT_CHECK(checkHeaders(headerVersion));
    GLINT_TRY(context, gpu::Context::adopt({device.instance, device.physicalDevice, device.device, device.queueFamily,
                                            device.getInstanceProcAddr, device.rayQuery, toDemands(device.demands),
                                            device.pipelineCache, device.allocationCallbacks, device.message,
                                            device.messageUser}));
    if (!context->info().usable())
        return makeError(ErrorCode::Unsupported, "{} cannot run Glint: it lacks {}", context->info().name,
                         joinText(context->info().missing, ", "));
    context->addShaders(gpu::shaders::reflect());
    return Context(std::move(context));
}

const std::string& Context::deviceName() const {
    return gpu_->info().name;
}

MemoryReport Context::memory() const {
    MemoryReport report;
    for (const auto& [allocation, use] : gpu_->memoryUses()) {
        auto known = std::ranges::find(report.uses, use.name, &MemoryUse::name);
        if (known == report.uses.end())
            known = report.uses.insert(known, {use.name, 0, 0});
        known->bytes += use.bytes;
        ++known->count;
        report.bytes += use.bytes;
    }
    std::ranges::sort(report.uses, [](const MemoryUse& a, const MemoryUse& b) {
        return a.bytes != b.bytes ? a.bytes > b.bytes : a.name < b.name;
    });
    report.taken = gpu::blockBytes(gpu_->allocator());
    return report;
}

const std::string& Context::driver() const {
    return gpu_->info().driver;
}

} // namespace glint
