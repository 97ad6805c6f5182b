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

} // namespace glint::gpu
