// The frame's constants, which every pass reads at binding 0 of set 0.
#ifndef GLINT_FRAME_FRAME_BLOCK_GLSL
#define GLINT_FRAME_FRAME_BLOCK_GLSL

#include "shared/frame_constants.h"

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
}
frame;

#endif
