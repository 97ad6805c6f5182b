// Settings as the tracing shaders take them. Enums are the numbers of glint/settings.hpp.
#ifndef GLINT_SHARED_TRACE_CONSTANTS_H
#define GLINT_SHARED_TRACE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct TraceConstants {
    float maxDistance;
    float thickness;
    float thicknessRelative; // of viewZ; 0 with the constant mode
    float roughnessFactor;
    uint maxSteps;
    uint step;
    uint selfCollisionSkip;
    uint flags;      // kTrace*
    float threshold; // already with strength and the half step of an 8-bit F0
    float roughnessFadeStart;
    float maxRoughness;
    float borderWidth;
};

GLINT_CONSTANT(uint, kTraceSmooth, 1);
GLINT_CONSTANT(uint, kTraceClipToFrustum, 2);
GLINT_CONSTANT(uint, kFadeBorderSmooth, 4);
GLINT_CONSTANT(uint, kFadeBorderLinear, 8);
GLINT_CONSTANT(uint, kFadeDistance, 16);
GLINT_CONSTANT(uint, kFadeIterations, 32);
GLINT_CONSTANT(uint, kFadeFacingCamera, 64);
GLINT_CONSTANT(uint, kFadeBackface, 128);

struct HierarchyConstants {
    uint screen; // 1: the screen source takes part
    uint sky;    // 1: so does the environment
};

struct CompositeConstants {
    uint model; // CompositeModel: 0 physical, 1 lerp
    uint fresnel;
    uint debugOutcome;
    float strength;
    float falloffExponent;
    uint maxSteps;
};

struct ViewConstants {
    uint view; // kView*
    uint maxSteps;
};

// Order of kViews in src/reflect/views.cpp.
GLINT_CONSTANT(uint, kViewReflection, 0);
GLINT_CONSTANT(uint, kViewWeight, 1);
GLINT_CONSTANT(uint, kViewWeights, 2);
GLINT_CONSTANT(uint, kViewSource, 3);
GLINT_CONSTANT(uint, kViewOutcome, 4);
GLINT_CONSTANT(uint, kViewNormal, 5);
GLINT_CONSTANT(uint, kViewDepth, 6);
GLINT_CONSTANT(uint, kViewRoughness, 7);
GLINT_CONSTANT(uint, kViewReflectivity, 8);
GLINT_CONSTANT(uint, kViewHitUv, 9);
GLINT_CONSTANT(uint, kViewHitDistance, 10);
GLINT_CONSTANT(uint, kViewLookups, 11);
GLINT_CONSTANT(uint, kViewRayDirection, 12);
GLINT_CONSTANT(uint, kViewRay, 13); // for programs: hitUV, outcome, lookups
GLINT_CONSTANT(uint, kViewCount, 14);

GLINT_SHARED_END

#endif
