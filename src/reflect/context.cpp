#include "glint/context.hpp"

#include "base/text.hpp"
#include "gpu/context.hpp"
#include "gpu/device_requirements.hpp"

namespace glint {

namespace {

gpu::Demands toDemands(DeviceDemands demands) {
    return demands == DeviceDemands::Screen ? gpu::Demands::Screen : gpu::Demands::Sources;
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

Context::Context(std::shared_ptr<gpu::Context> context) : gpu_(std::move(context)) {}
Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

Result<Context> Context::adopt(const HostDevice& device) {
    GLINT_TRY(context, gpu::Context::adopt({device.instance, device.physicalDevice, device.device, device.queueFamily,
                                            device.getInstanceProcAddr, device.rayQuery, toDemands(device.demands)}));
    if (!context->info().usable())
        return makeError(ErrorCode::Unsupported, "{} cannot run Glint: it lacks {}", context->info().name,
                         joinText(context->info().missing, ", "));
    context->addShaders(gpu::shaders::reflect());
    return Context(std::move(context));
}

const std::string& Context::deviceName() const {
    return gpu_->info().name;
}

const std::string& Context::driver() const {
    return gpu_->info().driver;
}

} // namespace glint
