// Settings as the tracing shaders take them. Enums are the numbers of glint/settings.hpp.
#ifndef GLINT_SHARED_TRACE_CONSTANTS_H
#define GLINT_SHARED_TRACE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct TraceConstants {
    float maxDistance;
    float thickness;
    float thicknessRelative; // of viewZ; 0 unless the mode is relative
    float roughnessFactor;
    uint maxSteps; // of the marcher that runs
    uint step;
    uint selfCollisionSkip;
    uint flags;      // kTrace*
    float threshold; // already with strength and the half step of an 8-bit F0
    float roughnessFadeStart;
    float maxRoughness;
    float borderWidth;
    uint minLevel; // of the depth pyramid
    uint maxLevel;
    uint baseSteps;
    float pixelSpacing;
    uint refinements;
    uint2 backFaceGroups; // that prepare/back_faces needs
};

GLINT_CONSTANT(uint, kTraceSmooth, 1);
GLINT_CONSTANT(uint, kTraceClipToFrustum, 2);
GLINT_CONSTANT(uint, kFadeBorderSmooth, 4);
GLINT_CONSTANT(uint, kFadeBorderLinear, 8);
GLINT_CONSTANT(uint, kFadeDistance, 16);
GLINT_CONSTANT(uint, kFadeIterations, 32);
GLINT_CONSTANT(uint, kFadeFacingCamera, 64);
GLINT_CONSTANT(uint, kFadeBackface, 128);
GLINT_CONSTANT(uint, kTraceBackDepth, 256); // back faces say how thick each surface is

// What classify.comp finds: how many rays there are, as the arguments of the indirect dispatches that trace them and
// that make what they look at: without a ray, nothing. The rays' pixels follow, x in the low half and y in the high
// half of a word.
struct RayListHeader {
    uint rayGroups[3];
    uint rayCount;
    uint pyramidGroups[3];
    uint backFaceGroups[3];
    uint padding[2];
};

GLINT_CONSTANT(uint, kRaysPerGroup, 64);
GLINT_CONSTANT(uint, kRayGroupsX, 64); // groups in a row of the dispatch: a row of all may be longer than devices take

struct PyramidConstants {
    float thickness;
    float thicknessRelative;
    uint flags; // kTraceBackDepth
    uint levels;
};

GLINT_CONSTANT(uint, kPyramidTile, 64);     // pixels a side that one group reduces
GLINT_CONSTANT(uint, kPyramidTileLevel, 6); // to one cell of this level
GLINT_CONSTANT(uint, kMaxPyramidLevels, 15);

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
GLINT_CONSTANT(uint, kViewColor, 14);
GLINT_CONSTANT(uint, kViewHitDepth, 15);
GLINT_CONSTANT(uint, kViewHitSuccess, 16);
GLINT_CONSTANT(uint, kViewProbes, 17);
GLINT_CONSTANT(uint, kViewWeightRays, 18);
GLINT_CONSTANT(uint, kViewWeightProbes, 19);
GLINT_CONSTANT(uint, kViewWeightSky, 20);
GLINT_CONSTANT(uint, kViewPlanar, 21);
GLINT_CONSTANT(uint, kViewWeightPlanar, 22);
GLINT_CONSTANT(uint, kViewRefraction, 23);
GLINT_CONSTANT(uint, kViewRefractionWeights, 24);
GLINT_CONSTANT(uint, kViewCount, 25);

GLINT_SHARED_END

#endif
