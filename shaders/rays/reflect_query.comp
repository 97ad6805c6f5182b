// The source `rays` through the driver's acceleration structures: rays/reflect_main.glsl.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "rays/surface_table.glsl"

#include "rays/query.glsl"
#include "rays/rays_inputs.glsl"

#include "rays/reflect_main.glsl"
