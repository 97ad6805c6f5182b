// The `hiz` marcher, for the frame's rays. Transparent layers share the march (refraction/layer_march.glsl).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "trace/ray_inputs.glsl"

#include "trace/hiz_march.glsl"

#include "trace/trace_main.glsl"
