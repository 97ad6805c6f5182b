// Determines the barrier that a use of a resource requires, from its earlier uses. Pure bookkeeping without Vulkan
// calls. The validation layer misses some hazards (writable storage buffers from dispatch to dispatch), so unit tests
// cover this file.
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
    bool discards = false; ///< the old content is not needed, so the layout transition may discard it
};

/// Accesses of a resource (or one mip level) since its last write.
struct ResourceState {
    VkPipelineStageFlags2 writeStages = 0; ///< the last write, or a later layout transition
    VkAccessFlags2 writeAccess = 0;
    VkPipelineStageFlags2 readStages = 0; ///< reads since then, for which the write is already visible
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

/// Returns the barrier to record before `use`, or none, and updates `state`.
///   read after write      waits for the write and makes it visible, once per kind of reader
///   write after read      waits for the readers
///   write after write     waits and makes available
///   another layout        counts as a write, ordered after all earlier accesses
std::optional<Barrier> transition(ResourceState& state, const Use& use);

// Acceleration structures are synchronized as the buffers that hold them (Vulkan 1.3, "Acceleration Structure Builds").

/// A build reads vertices, indices and instance records.
inline constexpr Use kBuildInput = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                    VK_ACCESS_2_SHADER_READ_BIT};
/// The build of a top level reads bottom levels.
inline constexpr Use kBuildReference = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                        VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR};
/// A build writes the structure. It also reads its scratch memory, and a structure that is refitted in place.
inline constexpr Use kBuildTarget = {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                                     VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR |
                                         VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
                                     VK_IMAGE_LAYOUT_UNDEFINED, true};
/// The ray queries of these shader stages read the top level and every bottom level that it refers to.
constexpr Use traversal(VkPipelineStageFlags2 shaderStages) {
    return {shaderStages, VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR};
}

} // namespace glint::gpu
