// The frame's constants and the settings in force, which every pass reads at binding 0 of set 0. Passes name the part
// that they use: `TraceConstants settings = frame.settings.trace;`.
#ifndef GLINT_FRAME_FRAME_BLOCK_GLSL
#define GLINT_FRAME_FRAME_BLOCK_GLSL

#include "shared/frame_constants.h"
#include "shared/settings_constants.h"

layout(scalar, set = 0, binding = 0) uniform FrameBlock {
    FrameConstants constants;
    SettingsConstants settings;
}
frame;

#endif
