// SPDX-License-Identifier: MIT
// Glint: reflections for any Vulkan renderer. Includes the public headers. docs/embedding.md and examples/embed
// show a host.
#pragma once

#include "glint/context.hpp"
#include "glint/error.hpp"
#include "glint/gbuffer.hpp"
#include "glint/host_acceleration_structure.hpp"
#include "glint/input_check.hpp"
#include "glint/inspection.hpp"
#include "glint/outputs.hpp"
#include "glint/planar.hpp"
#include "glint/probes.hpp"
#include "glint/ray_hits.hpp"
#include "glint/ray_scene.hpp"
#include "glint/reflections.hpp"
#include "glint/settings.hpp"
#include "glint/surface_table.hpp"
#include "glint/version.hpp"
#include "glint/view.hpp"
