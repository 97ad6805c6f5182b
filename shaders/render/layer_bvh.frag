// layer_main.glsl with rays for shadows, through Glint's own hierarchy.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/shadow_geometry.glsl"

#include "rays/bvh.glsl"

#include "render/layer_main.glsl"
