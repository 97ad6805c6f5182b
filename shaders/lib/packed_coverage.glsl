// The fourth channel of the material that prepare resolves: the coverage; where the host states F90, F90; with several
// samples a pixel both, as an integer that a half holds exactly: the part that is not covered, up to fifteen sixteenths, and
// F90 in 127 steps.
#ifndef GLINT_LIB_PACKED_COVERAGE_GLSL
#define GLINT_LIB_PACKED_COVERAGE_GLSL

#include "shared/frame_constants.h"

const float kOpenSteps = 16.0;
const float kF90Steps = 127.0;

float packedCoverage(FrameConstants frame, float coverage, float f90) {
    if ((frame.flags & kInputF90) == 0u)
        return coverage;
    if ((frame.flags & kInputSamples) == 0u)
        return f90;
    float open = min(round((1.0 - coverage) * kOpenSteps), kOpenSteps - 1.0);
    return open * (kF90Steps + 1.0) + round(f90 * kF90Steps);
}

/// Coverage, F90.
vec2 unpackCoverage(FrameConstants frame, float packed) {
    if ((frame.flags & kInputF90) == 0u)
        return vec2(packed, 1.0);
    if ((frame.flags & kInputSamples) == 0u)
        return vec2(1.0, packed);
    float open = floor(packed / (kF90Steps + 1.0));
    return vec2(1.0 - open / kOpenSteps, (packed - open * (kF90Steps + 1.0)) / kF90Steps);
}

#endif
