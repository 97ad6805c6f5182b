// Cell by cell through the depth pyramid: docs/techniques/hiz.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/hiz_march.glsl"

#include "trace/trace_main.glsl"
