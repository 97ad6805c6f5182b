// What traces rays.
#pragma once

#include "glint/setting_info.hpp"

namespace glint {

/// Auto: Query where the device has it enabled, else Bvh.
/// Query: VK_KHR_ray_query, the driver's acceleration structures.
/// Bvh: Glint's own hierarchy, built on the CPU and traversed in compute; any device.
GLINT_SETTING_ENUM(RayBackend, Auto, Query, Bvh)

} // namespace glint
