// Settings for the tracing shaders. Enums are the numbers of glint/settings.hpp.
#ifndef GLINT_SHARED_TRACE_CONSTANTS_H
#define GLINT_SHARED_TRACE_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct TraceConstants {
    float maxDistance;
    float thickness;
    float thicknessRelative; // fraction of viewZ; 0 unless the mode is relative
    float roughnessFactor;
    uint maxSteps; // of the marcher in use
    uint step;
    uint selfCollisionSkip;
    uint flags;      // kTrace*
    float threshold; // includes strength and the half step of an 8-bit F0
    float roughnessFadeStart;
    float maxRoughness;
    float borderWidth;
    uint minLevel; // of the depth pyramid
    uint maxLevel;
    uint baseSteps;
    float pixelSpacing;
    uint refinements;
    float inferredWeight; // of answers with outcome inferred; 0: none
};

GLINT_CONSTANT(uint, kTraceSmooth, 1);
GLINT_CONSTANT(uint, kTraceClipToFrustum, 2);
GLINT_CONSTANT(uint, kFadeBorderSmooth, 4);
GLINT_CONSTANT(uint, kFadeBorderLinear, 8);
GLINT_CONSTANT(uint, kFadeDistance, 16);
GLINT_CONSTANT(uint, kFadeIterations, 32);
GLINT_CONSTANT(uint, kFadeFacingCamera, 64);
GLINT_CONSTANT(uint, kFadeBackface, 128);
GLINT_CONSTANT(uint, kTraceBackDepth, 256);      // back faces give each surface's thickness
GLINT_CONSTANT(uint, kTraceLobe, 512);           // rays sample the lobe of rough surfaces
GLINT_CONSTANT(uint, kTraceRecords, 1024);       // how each ray ended is kept
GLINT_CONSTANT(uint, kTraceCones, 2048);         // answers of rough surfaces' rays are blurred by the lobe's width
GLINT_CONSTANT(uint, kTraceBackInPlace, 4096);   // backViewZ is the host's image, one texel a pixel: lib/back_face.glsl
GLINT_CONSTANT(uint, kTraceListedOnly, 8192);    // pixels off the ray list have no answer stored: trace/listed.glsl
GLINT_CONSTANT(uint, kTraceUncertain, 16384);    // uncertain answers weigh less: trace/certainty.glsl
GLINT_CONSTANT(uint, kTraceCertainty, 32768);    // answers are stored as debug.certainty says
GLINT_CONSTANT(uint, kTraceNextSky, 65536);      // the environment answers for the weight that the screen leaves
GLINT_CONSTANT(uint, kTraceNextOther, 131072);   // another source does, whose answer is not known yet
GLINT_CONSTANT(uint, kTraceConesAtHits, 262144); // with kTraceCones: where the ray hits; otherwise by resolve/lobe

// Written by list.comp: the number of rays, as the arguments of the indirect dispatches that trace the rays and that
// build their inputs. Without rays these dispatches are empty. The rays' pixels follow, x in the low half and y in the
// high half of a word.
struct RayListHeader {
    uint rayGroups[3];
    uint rayCount;
    uint pyramidGroups[3];
    uint backFaceGroups[3];
    uint pictureGroups[3]; // as pyramidGroups, if any of the rays starts on a rough surface
};

GLINT_CONSTANT(uint, kRaysPerGroup, 64);
GLINT_CONSTANT(uint, kRayGroupsX, 64); // groups in a row of the dispatch: one row of all may exceed device limits

struct RayListConstants {
    uint2 tiles;          // of the traced image
    uint2 pyramidGroups;  // if there are rays, else 0
    uint2 backFaceGroups; // if there are rays, else 0
    uint always;          // both and the picture also without rays: those of another lobe need them
};

GLINT_CONSTANT(uint, kRayTileWidth, 8);
GLINT_CONSTANT(uint, kRayTilePixels, 64);
GLINT_CONSTANT(uint, kTilesPerBlock, 64);   // tiles that one group of list.comp lists
GLINT_CONSTANT(uint, kFromRough, 0x10000u); // of a block: some ray starts on a rough surface

struct PyramidConstants {
    float thickness;
    float thicknessRelative;
    uint flags; // kTraceBackDepth
    uint levels;
};

GLINT_CONSTANT(uint, kPyramidTile, 64);     // pixels a side that one group reduces
GLINT_CONSTANT(uint, kPyramidTileLevel, 6); // into one cell of this level
GLINT_CONSTANT(uint, kMaxPyramidLevels, 15);

// The blurred copies of the picture: trace/picture.comp.
GLINT_CONSTANT(uint, kPictureTile, 64); // pixels a side that one group reduces, as kPyramidTile
GLINT_CONSTANT(uint, kPictureLevels, 6);

struct CompositeConstants {
    uint model; // CompositeModel: 0 physical, 1 lerp
    uint fresnel;
    uint debugOutcome; // kDebug*
    float strength;
    float falloffExponent;
};

GLINT_CONSTANT(uint, kDebugOutcome, 1);
GLINT_CONSTANT(uint, kDebugClipped, 2); // rays end at the frustum

GLINT_SHARED_END

#endif
