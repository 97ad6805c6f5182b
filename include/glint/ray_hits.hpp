// SPDX-License-Identifier: MIT
// Ray hits of the source `rays`, for hosts that shade hits with their own lighting model.
#pragma once

#include "glint/gbuffer.hpp"

#include <cstdint>
#include <functional>

namespace glint {

/// The hit of one ray, in GLSL's `scalar` layout. Instance and primitive are the host's indices (RayScene).
struct RayHit {
    uint32_t pixel = 0;             ///< pixel of the frame: x in the low 16 bits, y in the high 16 bits
    float distance = 0;             ///< metres; `rays.tMax` for a miss
    uint32_t instance = 0;          ///< 0xffffffff: a miss
    uint32_t primitive = 0;         ///< triangle index in the instance's mesh
    float barycentrics[2] = {0, 0}; ///< weights of the triangle's second and third vertex
    uint32_t frontFace = 0;         ///< 1: the triangle's front faces the ray's origin
    float coneWidth = 0;            ///< metres: width of the pixel's cone at the hit, for mip selection
    float originWS[3] = {0, 0, 0};
    float directionWS[3] = {0, 0, 0}; ///< unit
};

/// Inputs and output of the host's hit shading in one frame. All are ready for compute shaders.
struct RayHits {
    /// Offset 0: VkDispatchIndirectCommand for groups of 64 threads, 64 groups per row. Offset 12: ray count, uint32.
    /// Ray index = gl_WorkGroupID.y * 4096 + gl_WorkGroupID.x * 64 + gl_LocalInvocationIndex. A thread must exit if its
    /// ray index is not below the ray count. Usages: INDIRECT_BUFFER, STORAGE_BUFFER.
    VkBuffer arguments = VK_NULL_HANDLE;
    VkBuffer hits = VK_NULL_HANDLE; ///< RayHit[]; STORAGE_BUFFER
    VkDeviceSize hitsSize = 0;      ///< bytes
    /// RGBA16F storage image in VK_IMAGE_LAYOUT_GENERAL, cleared. At each ray's pixel the host stores reflected
    /// radiance in rgb, not multiplied by the weight, and a weight [0, 1] in a (0: no result for this pixel).
    HostImage answer;
};

/// Records the host's hit shading into the frame's command buffer, outside of rendering. It may bind any pipeline;
/// Glint binds its own pipelines again.
using ShadeHits = std::function<void(VkCommandBuffer commands, const RayHits& hits)>;

} // namespace glint
