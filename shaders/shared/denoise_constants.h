// Inputs of the passes of `denoise` besides FrameConstants.
#ifndef GLINT_SHARED_DENOISE_CONSTANTS_H
#define GLINT_SHARED_DENOISE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct BlurConstants {
    float2 sourceSize; // pixels of the source image
    float2 targetSize; // pixels of the target image
    uint vertical;     // 0: along x
    uint maxTaps;      // odd
    float strength;    // blur.strength
    float roughnessFactor;
};

struct UpsampleConstants {
    float2 sourceSize; // pixels of the source image
    float threshold;   // this and the next two as in TraceConstants: which pixels reflect
    float roughnessFadeStart;
    float maxRoughness;
    uint mirrorRays; // 1: rays were not jittered
    float strength;  // as in BlurConstants
    float roughnessFactor;
};

GLINT_SHARED_END

#endif
