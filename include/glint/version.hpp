// SPDX-License-Identifier: MIT
// The version of these headers, and of the library that the host runs with. The build takes its version from here.
#pragma once

#include "glint/api.hpp"

#include <cstdint>

#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 1
#define GLINT_VERSION_PATCH 0

/// Version as one number, which increases with each version.
#define GLINT_MAKE_VERSION(major, minor, patch) ((major)*1000000u + (minor)*1000u + (patch))
#define GLINT_VERSION GLINT_MAKE_VERSION(GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH)

namespace glint {

/// Returns the version of the library, as GLINT_VERSION. Before 1.0, headers and library must agree in MAJOR and MINOR;
/// Context::adopt checks it.
GLINT_API uint32_t version();

} // namespace glint
