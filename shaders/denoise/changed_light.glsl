// How much of a history is light of the past, where denoise/change.comp found that light has changed.
#ifndef GLINT_DENOISE_CHANGED_LIGHT_GLSL
#define GLINT_DENOISE_CHANGED_LIGHT_GLSL

#include "frame/frame_block.glsl"

/// What change.comp found around the pixel `at` of the previous frame.
vec3 lightChange(sampler2D changed, vec2 at) {
    const float kTile = float(kSentinelTile);
    vec2 last = (ceil(frame.constants.prevSize / kTile) - 0.5) * kTile; // no tile lies beyond
    return textureLod(changed, min(at, last) / (vec2(textureSize(changed, 0)) * kTile), 0.0).rgb;
}

/// Frames of a mean over `frames` that still count.
float framesKept(float frames, vec3 change) {
    const float kPower = 10.0; // with a tenth changed a third of the frames count
    float kept = frames * pow(1.0 - change.r, kPower);
    return mix(kept, min(kept, frame.settings.denoise.fastFrames), change.g);
}

#endif
