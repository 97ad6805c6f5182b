// A depth lookup every few pixels along the ray: docs/techniques/linear.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/linear_march.glsl"

#include "trace/trace_main.glsl"
