// The frame's own march, written down: trace/ray_log.glsl
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#define GLINT_RAY_LOG

#include "trace/proxy_march.glsl"

#include "trace/trace_main.glsl"
