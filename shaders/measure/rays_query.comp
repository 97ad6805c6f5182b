// Rays to be timed, through the driver's acceleration structures: measure/rays_main.glsl.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/query.glsl"

#include "measure/rays_main.glsl"
