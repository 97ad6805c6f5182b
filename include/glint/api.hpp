// SPDX-License-Identifier: MIT
// Symbol export for a shared library of Glint. Symbols without GLINT_API are hidden.
#pragma once

#if defined(GLINT_SHARED) && (defined(__GNUC__) || defined(__clang__))
#define GLINT_API __attribute__((visibility("default")))
#else
#define GLINT_API
#endif
