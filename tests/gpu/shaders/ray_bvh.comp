// Rays through the back end `bvh`: tests/gpu/ray_scene_test.cpp.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "ray_alpha.glsl"
#include "rays/bvh.glsl"
#include "ray_main.glsl"
