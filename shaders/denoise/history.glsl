// Whether the denoiser's images of the previous frame hold that frame.
#ifndef GLINT_DENOISE_HISTORY_GLSL
#define GLINT_DENOISE_HISTORY_GLSL

#include "frame/frame_block.glsl"

/// Also false where the previous frame was recorded but never executed: its images then hold an older frame.
bool hasDenoiserHistory() {
    DenoiseConstants denoise = frame.settings.denoise;
    return denoise.historyExpected != 0u && denoise.historyTag == denoise.historyExpected;
}

#endif
