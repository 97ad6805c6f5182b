// Hits to be handed out, through Glint's own hierarchy: rays/hits_main.glsl.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/bvh.glsl"

#include "rays/hits_main.glsl"
