// Hits handed out: what the source `rays` has met, for hosts that shade it by their own light model.
#pragma once

#include "glint/gbuffer.hpp"

#include <cstdint>
#include <functional>

namespace glint {

/// One ray, in GLSL's `scalar` layout. Instance and primitive are the host's own numbers (RayScene).
struct RayHit {
    uint32_t pixel = 0;             ///< of the picture: x in the low 16 bits, y in the high ones
    float distance = 0;             ///< metres; `rays.tMax` if nothing was met
    uint32_t instance = 0;          ///< 0xffffffff: nothing was met
    uint32_t primitive = 0;         ///< triangle of the instance's mesh
    float barycentrics[2] = {0, 0}; ///< weights of its second and third vertex
    uint32_t frontFace = 0;         ///< 1: its front looks at the ray's origin
    float coneWidth = 0;            ///< metres: of the pixel's cone where it met, for mips
    float originWS[3] = {0, 0, 0};
    float directionWS[3] = {0, 0, 0}; ///< unit
};

/// What the host's shading is given while a frame is recorded. All of it is ready for compute shaders.
struct RayHits {
    /// VkDispatchIndirectCommand at offset 0 for groups of 64 threads, 64 groups a row, and the number of rays, a
    /// uint32, at offset 12. Ray number = gl_WorkGroupID.y * 4096 + gl_WorkGroupID.x * 64 + gl_LocalInvocationIndex;
    /// those from the number of rays on are not there. Usages: INDIRECT_BUFFER, STORAGE_BUFFER.
    VkBuffer arguments = VK_NULL_HANDLE;
    VkBuffer hits = VK_NULL_HANDLE; ///< RayHit[]; STORAGE_BUFFER
    VkDeviceSize hitsSize = 0;      ///< bytes
    /// RGBA16F storage image in VK_IMAGE_LAYOUT_GENERAL, cleared: at each ray's pixel the host stores reflected
    /// radiance, not weighted, and a weight [0, 1] (0: nothing is known there).
    HostImage answer;
};

/// Records into the frame's command buffer, outside of rendering. It may use any pipeline; Glint binds its own again.
using ShadeHits = std::function<void(VkCommandBuffer commands, const RayHits& hits)>;

} // namespace glint
