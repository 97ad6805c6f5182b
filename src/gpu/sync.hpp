// Which barrier a use of a resource needs, worked out from its uses so far. Pure bookkeeping, no Vulkan call: the
// validation layer misses some hazards (writable storage buffers from dispatch to dispatch), so this has unit tests.
#pragma once

#include "gpu/api.hpp"

#include <optional>

namespace glint::gpu {

/// One use of a resource by a pass. Buffers leave the layout undefined.
struct Use {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool writes = false;
    bool discards = false; ///< the old content is not needed: the layout transition may throw it away
};

/// What has happened to a resource (or one mip level) since its last write.
struct ResourceState {
    VkPipelineStageFlags2 writeStages = 0; ///< the last write, or the layout transition that came after it
    VkAccessFlags2 writeAccess = 0;
    VkPipelineStageFlags2 readStages = 0; ///< reads since, all of them made visible already
    VkAccessFlags2 readAccess = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;

    bool operator==(const ResourceState&) const = default;
};

struct Barrier {
    VkPipelineStageFlags2 srcStages = 0;
    VkAccessFlags2 srcAccess = 0;
    VkPipelineStageFlags2 dstStages = 0;
    VkAccessFlags2 dstAccess = 0;
    VkImageLayout oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkImageLayout newLayout = VK_IMAGE_LAYOUT_UNDEFINED;

    bool operator==(const Barrier&) const = default;
};

/// The barrier to record before `use`, or none; `state` becomes what holds after it.
///   read after write      waits for the write and makes it visible, once per kind of reader
///   write after read      waits for the readers
///   write after write     waits and makes available
///   another layout        is a write of its own, ordered after everything before it
std::optional<Barrier> transition(ResourceState& state, const Use& use);

// Acceleration structures are synchronized as the buffers that hold them (Vulkan 1.3, "Acceleration Structure Builds").

/// Vertices, indices and instance records that a build reads.
inline constexpr Use kBuildInput = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                    VK_ACCESS_2_SHADER_READ_BIT};
/// A bottom level that the build of a top level reads.
inline constexpr Use kBuildReference = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                        VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR};
/// What a build writes; its scratch memory and the structure that is refitted in place are read too.
inline constexpr Use kBuildTarget = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                     VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR |
                                         VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
                                     VK_IMAGE_LAYOUT_UNDEFINED, true};
/// What the ray queries of these shaders read: the top level and every bottom level that it refers to.
constexpr Use traversal(VkPipelineStageFlags2 shaderStages) {
    return {shaderStages, VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR};
}

} // namespace glint::gpu
