#pragma once

#include <glm/glm.hpp>
#include <vulkan/vulkan.h>

namespace glint::gpu {

/// An address as structs that C++ and GLSL share hold it: its low and its high half.
inline glm::uvec2 addressWords(VkDeviceAddress address) {
    return {static_cast<uint32_t>(address), static_cast<uint32_t>(address >> 32)};
}

} // namespace glint::gpu
