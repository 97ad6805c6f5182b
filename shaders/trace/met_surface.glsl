// What a screen ray may meet: the frame's surfaces, or in a march of its own the transparent surfaces in front of them
// (screen.transparents). The surface that a ray leaves is always the frame's (frame/prepared.glsl).
#ifndef GLINT_TRACE_MET_SURFACE_GLSL
#define GLINT_TRACE_MET_SURFACE_GLSL

#include "frame/prepared.glsl"

layout(constant_id = 1) const bool kAmongTransparents = false;
layout(set = 0, binding = 43) uniform sampler2D metViewZ;    // as viewZ
layout(set = 0, binding = 44) uniform usampler2D metSurface; // as surface

#endif
