// SPDX-License-Identifier: MIT
// What the headers for C and for C++ share: the version of these headers, and the export of symbols.
#pragma once

#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 1
#define GLINT_VERSION_PATCH 0

/// Version as one number, which increases with each version.
#define GLINT_MAKE_VERSION(major, minor, patch) ((major)*1000000u + (minor)*1000u + (patch))
#define GLINT_VERSION GLINT_MAKE_VERSION(GLINT_VERSION_MAJOR, GLINT_VERSION_MINOR, GLINT_VERSION_PATCH)

// Of a shared library only symbols with GLINT_API are visible. The package defines GLINT_SHARED for hosts of a shared
// library, the build GLINT_BUILDING for the library's own sources.
#if defined(GLINT_SHARED) && defined(_WIN32) && defined(GLINT_BUILDING)
#define GLINT_API __declspec(dllexport)
#elif defined(GLINT_SHARED) && defined(_WIN32)
#define GLINT_API __declspec(dllimport)
#elif defined(GLINT_SHARED) && (defined(__GNUC__) || defined(__clang__))
#define GLINT_API __attribute__((visibility("default")))
#else
#define GLINT_API
#endif
