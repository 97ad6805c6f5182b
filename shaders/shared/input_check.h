// Samples of the host's images, as stored, for the check of its declarations (src/reflect/check).
#ifndef GLINT_SHARED_INPUT_CHECK_H
#define GLINT_SHARED_INPUT_CHECK_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct InputSample {
    float4 normal;
    float4 roughness; // texel of the image that holds it
    float depth[5];   // of the pixel and those left, right, above, below
    float motion[3];
};

/// A regular grid: sample (i, j) is pixel 1 + stride * (i, j).
struct InputSampleConstants {
    uint2 grid;
    uint stride;
};

GLINT_CONSTANT(uint, kMostInputSamples, 2048);

GLINT_SHARED_END

#endif
