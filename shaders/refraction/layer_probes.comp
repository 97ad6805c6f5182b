// layer_main.glsl, with the host's probes.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#define GLINT_PROBES
#include "refraction/layer_main.glsl"
