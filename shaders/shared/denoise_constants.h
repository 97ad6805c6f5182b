// Settings of `denoise` and `reuse`, and what differs between their passes.
#ifndef GLINT_SHARED_DENOISE_CONSTANTS_H
#define GLINT_SHARED_DENOISE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct DenoiseConstants {
    uint reuseSamples;
    float reuseRadius;    // pixels
    float historyFrames;  // most frames in the mean
    float disocclusion;   // fraction of viewZ
    float lobeTrail;      // fraction of the lobe's width
    float filterRadius;   // pixels
    float noiseTarget;    // fraction of the mean
    float fastFrames;     // most frames in the short mean
    float firefly;        // multiples of the mean; 0: no limit
    uint rayRate;         // kRate*
    uint comparesMeans;   // 1: the short mean shortens the long one
    uint hitMotion;       // 1: what moves in reflections is followed
    uint virtualMotion;   // kVirtual*
    float stableFrames;   // most frames in the stabilized brightness; 0: it is not stabilized
    uint mirrored;        // 1: what mirrors show is averaged as well, behind them: lib/mirrored.glsl
    uint historyExpected; // number of the recording that the history should hold; 0: there is none
    uint historyTag;      // number of the one that it holds: written by the GPU
};

// Rough pixels that send a ray (reuse.rate).
GLINT_CONSTANT(uint, kRateFull, 0);
GLINT_CONSTANT(uint, kRateQuarter, 1);      // one of 2 x 2
GLINT_CONSTANT(uint, kRateCheckerboard, 2); // two of 2 x 2
GLINT_CONSTANT(uint, kRateAdaptive, 3);     // one of these for each tile

// Where the previous frame is looked up (denoise.virtualMotion). Each includes those before it.
GLINT_CONSTANT(uint, kVirtualSurface, 0); // where the surface was
GLINT_CONSTANT(uint, kVirtualFlat, 1);    // where a flat mirror showed what the ray met
GLINT_CONSTANT(uint, kVirtualCurved, 2);  // where a mirror with the surface's curvature did

GLINT_CONSTANT(uint, kRateTile, 8);     // pixels on a side of a tile of the adaptive rate
GLINT_CONSTANT(uint, kSentinelTile, 5); // pixels on a side that share one sentinel (rays/sentinels_main.glsl)

// Push constant of denoise/gather: which answers there are, and which of the two comes first.
GLINT_CONSTANT(uint, kJoinScreen, 1);
GLINT_CONSTANT(uint, kJoinRays, 2);
GLINT_CONSTANT(uint, kJoinRaysFirst, 4);

GLINT_SHARED_END

#endif
