// Settings of `blur`, and what differs between its passes.
#ifndef GLINT_SHARED_RESOLVE_CONSTANTS_H
#define GLINT_SHARED_RESOLVE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct BlurConstants {
    uint maxTaps;   // odd
    float strength; // blur.strength
    float roughnessFactor;
};

struct BlurPassConstants {
    float2 sourceSize; // pixels of the source image
    float2 targetSize; // pixels of the target image
    uint vertical;     // 0: along x
};

GLINT_SHARED_END

#endif
