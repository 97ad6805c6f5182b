// What the passes of `denoise` take besides FrameConstants.
#ifndef GLINT_SHARED_DENOISE_CONSTANTS_H
#define GLINT_SHARED_DENOISE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct BlurConstants {
    float2 sourceSize; // pixels of the image that is read
    float2 targetSize; // pixels of the one that is written
    uint vertical;     // 0: along x
    uint maxTaps;      // odd
    float strength;    // blur.strength
    float roughnessFactor;
};

struct UpsampleConstants {
    float2 sourceSize; // pixels of the image that is read
    float threshold;   // as TraceConstants have these three: which pixels reflect at all
    float roughnessFadeStart;
    float maxRoughness;
    uint mirrorRays; // 1: rays were not jittered
    float strength;  // as BlurConstants
    float roughnessFactor;
};

GLINT_SHARED_END

#endif
