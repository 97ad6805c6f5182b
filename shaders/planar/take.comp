// shaders/planar/take_main.glsl, of depth images with one sample a pixel.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

layout(set = 0, binding = 2) uniform sampler2D hostDepth;
#include "planar/take_main.glsl"
