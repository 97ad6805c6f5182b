// SPDX-License-Identifier: MIT
// The version of the library that the host runs with. glint/api.h has the version of the headers, GLINT_VERSION.
#pragma once

#include "glint/api.h"

#include <cstdint>

namespace glint {

/// Returns the version of the library, as GLINT_VERSION. Before 1.0, headers and library must agree in MAJOR and MINOR;
/// Context::adopt checks it.
GLINT_API uint32_t version();

} // namespace glint
