// Rays to be timed, through Glint's own hierarchy: measure/rays_main.glsl.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/bvh.glsl"

#include "measure/rays_main.glsl"
