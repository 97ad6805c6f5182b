// The frame's own combining, written down for one pixel: trace/log/pixel.comp says which.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#define GLINT_RAY_LOG

#include "hierarchy/combine_main.glsl"
