// SPDX-License-Identifier: MIT
// The back end that traces rays.
#pragma once

#include "glint/setting_info.hpp"

namespace glint {

/// Auto: the faster one that can be had: Query if ray queries are enabled, but Bvh on a device that is a CPU, unless
/// the scene's triangles do not fit into one of its storage buffers. Query: VK_KHR_ray_query with the driver's
/// acceleration structures. Bvh: Glint's own hierarchy, built on the CPU and traversed in compute shaders. Runs on any
/// device.
GLINT_SETTING_ENUM(RayBackend, Auto, Query, Bvh)

} // namespace glint
