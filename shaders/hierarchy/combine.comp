// All sources under one rule: hierarchy/combine_main.glsl, docs/techniques/composite.md
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "hierarchy/combine_main.glsl"
