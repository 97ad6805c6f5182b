// Names that a host may have as macros when it includes Glint: those of X11, and those of windows.h. embed.cmake
// compiles every public header after this one. Standard and Vulkan headers come first: whether they bear it is not our
// matter.
#pragma once

#include <vulkan/vulkan_core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#else
#define Above 0
#define Always 2
#define Below 1
#define Bool int
#define Complex 0
#define False 0
#define None 0L
#define Status int
#define Success 0
#define True 1
#endif

#define CONST const
#define DELETE (0x00010000L)
#define ERROR 0
#define IN
#define OPAQUE 2
#define OPTIONAL
#define OUT
#define TRANSPARENT 1
#define VOID void
#define far
#define interface struct
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define near
#define small char
