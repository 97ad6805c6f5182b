// The frame's constants and the depth, normal and roughness that prepare converted, for the passes that read both.
#ifndef GLINT_FRAME_PREPARED_GLSL
#define GLINT_FRAME_PREPARED_GLSL

#include "frame/frame_block.glsl"

layout(set = 0, binding = 1) uniform sampler2D viewZ;    // metres; kBackgroundZ where no surface was drawn
layout(set = 0, binding = 2) uniform usampler2D surface; // lib/surface.glsl

#endif
