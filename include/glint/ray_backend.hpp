// SPDX-License-Identifier: MIT
// The back end that traces rays.
#pragma once

#include "glint/setting_info.hpp"

namespace glint {

/// - Auto: Query if ray queries are enabled, else Bvh. On a device that is a CPU also Bvh, which is faster there,
///   as long as the scene's triangles fit into one buffer.
/// - Query: VK_KHR_ray_query with the driver's acceleration structures.
/// - Bvh: Glint's own hierarchy, built on the CPU and traversed in compute shaders. Runs on any device.
GLINT_SETTING_ENUM(RayBackend, Auto, Query, Bvh)

} // namespace glint
