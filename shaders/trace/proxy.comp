// One lookup, where the pixel's probe volume says: docs/techniques/proxy.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/proxy_march.glsl"

#include "trace/trace_main.glsl"
