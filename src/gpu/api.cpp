#include "gpu/api.hpp"

namespace glint::gpu {

void Api::loadInstance(PFN_vkGetInstanceProcAddr getInstanceProcAddr, VkInstance instance) {
    GetInstanceProcAddr = getInstanceProcAddr;
#define GLINT_VK_LOAD(name) name = reinterpret_cast<PFN_vk##name>(GetInstanceProcAddr(instance, "vk" #name));
    GLINT_VK_INSTANCE_FUNCTIONS(GLINT_VK_LOAD)
    GLINT_VK_SURFACE_FUNCTIONS(GLINT_VK_LOAD)
#undef GLINT_VK_LOAD
}

void Api::loadDevice(VkDevice device) {
#define GLINT_VK_LOAD(name) name = reinterpret_cast<PFN_vk##name>(GetDeviceProcAddr(device, "vk" #name));
    GLINT_VK_DEVICE_FUNCTIONS(GLINT_VK_LOAD)
    GLINT_VK_DEBUG_FUNCTIONS(GLINT_VK_LOAD)
    GLINT_VK_RAY_FUNCTIONS(GLINT_VK_LOAD)
    GLINT_VK_SWAPCHAIN_FUNCTIONS(GLINT_VK_LOAD)
#undef GLINT_VK_LOAD
}

const char* Api::firstMissing() const {
#define GLINT_VK_CHECK(name)                                                                                           \
    if (!name)                                                                                                         \
        return "vk" #name;
    GLINT_VK_INSTANCE_FUNCTIONS(GLINT_VK_CHECK)
    GLINT_VK_DEVICE_FUNCTIONS(GLINT_VK_CHECK)
    return nullptr;
}

const char* Api::firstMissingForRays() const {
    GLINT_VK_RAY_FUNCTIONS(GLINT_VK_CHECK)
    return nullptr;
}

const char* Api::firstMissingForWindows() const {
    GLINT_VK_SURFACE_FUNCTIONS(GLINT_VK_CHECK)
    GLINT_VK_SWAPCHAIN_FUNCTIONS(GLINT_VK_CHECK)
#undef GLINT_VK_CHECK
    return nullptr;
}

} // namespace glint::gpu
