// peel_main.glsl over a G-buffer with one sample a pixel.
#version 460
#extension GL_EXT_nonuniform_qualifier : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/peel_main.glsl"

layout(set = 0, binding = 11) uniform sampler2D solid; // reversed depth of the G-buffer

float solidDepth(ivec2 px) {
    return texelFetch(solid, px, 0).r;
}
