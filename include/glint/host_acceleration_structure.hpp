// SPDX-License-Identifier: MIT
// A top-level acceleration structure of the host, for a RayScene without triangles of its own (RayScene::adopt).
#pragma once

#include "glint/api.h"

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <span>

namespace glint {

/// How a hit states its number, which is the index of its SurfaceInstance and RayHit::instance.
enum class InstanceNumbering : uint8_t {
    TopLevelIndex, ///< index of the instance in the top level; each bottom level has one geometry
    /// The instance's custom index (instanceCustomIndex, 24 bits) plus the index of the geometry in its bottom level:
    /// where bottom levels have several geometries, each geometry has a SurfaceInstance, in their order.
    CustomIndex,
};

/// The host's top level and what Glint cannot read from it. The host owns, builds and updates it. Triangles of every
/// format count; other geometries (boxes) stop no ray, and motion instances are not supported. Masks, opaque flags and
/// culling are those of the host's instances and geometries, with the meaning of RayInstance's members: a back face is
/// one that Vulkan reports as such, and instances whose surfaces are not opaque must not be built as opaque.
struct HostAccelerationStructure {
    VkAccelerationStructureKHR topLevel = VK_NULL_HANDLE; ///< of the type TOP_LEVEL
    /// As many as the SurfaceTable's instances. The number of every hit must be below it: the GPU does not check.
    uint32_t instanceCount = 0;
    InstanceNumbering numbering = InstanceNumbering::TopLevelIndex;
    /// Triangles of each number, for rays.sampleLights: at most as many as its SurfaceMesh has; 0 where no ray can hit
    /// it. Empty: unknown, and paths alone find emissive surfaces, with the same mean and more noise.
    std::span<const uint32_t> triangleCounts;
    /// World-space box of all instances that transmit light, metres. Screen-space answers whose way crosses it are
    /// replaced by rays, so the default, which is everywhere, costs rays in scenes with such instances.
    std::array<float, 3> transparentLowWS = {-1e18f, -1e18f, -1e18f};
    std::array<float, 3> transparentHighWS = {1e18f, 1e18f, 1e18f};
};

} // namespace glint
