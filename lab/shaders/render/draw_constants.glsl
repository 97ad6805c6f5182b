// The instance that a draw shows.
#ifndef GLINT_RENDER_DRAW_CONSTANTS_GLSL
#define GLINT_RENDER_DRAW_CONSTANTS_GLSL

#include "shared/gpu_scene.h"

layout(push_constant, scalar) uniform DrawBlock {
    DrawConstants constants;
} draw;

#endif
