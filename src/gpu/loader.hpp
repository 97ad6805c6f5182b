// The Vulkan loader of the machine, opened while the program runs. Only our own programs open it: the library uses the
// host's getInstanceProcAddr.
#pragma once

#include "base/result.hpp"

#include <vulkan/vulkan_core.h>

namespace glint::gpu {

/// Errors: NotFound if there is no loader.
Result<void*> openLoader();
PFN_vkGetInstanceProcAddr instanceProcAddr(void* loader);
void closeLoader(void* loader);

} // namespace glint::gpu
