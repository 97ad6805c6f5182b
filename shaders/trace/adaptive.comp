// Equal steps in 3D and a binary search: docs/techniques/adaptive.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/adaptive_march.glsl"

#include "trace/trace_main.glsl"
