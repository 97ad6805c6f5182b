// What is written down about one pixel's ray when it is inspected: include/glint/inspection.hpp says what each means.
#ifndef GLINT_SHARED_RAY_LOG_H
#define GLINT_SHARED_RAY_LOG_H

#include "shared/hierarchy.h"
#include "shared/types.h"

GLINT_SHARED_BEGIN

// What one look at a depth decided. src/reflect/inspection.cpp has the words.
GLINT_CONSTANT(uint, kSampleFront, 0);    // the ray is in front of all that is there
GLINT_CONSTANT(uint, kSampleBehind, 1);   // behind it, and no more was asked
GLINT_CONSTANT(uint, kSampleEmpty, 2);    // a cell that shows nothing
GLINT_CONSTANT(uint, kSampleLookInto, 3); // a cell that has to be looked into
GLINT_CONSTANT(uint, kSamplePasses, 4);   // met nothing, though it is neither in front nor behind
GLINT_CONSTANT(uint, kSampleHit, 5);
GLINT_CONSTANT(uint, kSampleSide, 6);
GLINT_CONSTANT(uint, kSampleBackFace, 7);
GLINT_CONSTANT(uint, kSampleGrazes, 8);
GLINT_CONSTANT(uint, kSampleNearly, 9);
GLINT_CONSTANT(uint, kSamplePlaces, 10); // the neighbour in which the hit's exact place lies
GLINT_CONSTANT(uint, kSampleDecisionCount, 11);

struct LoggedSample {
    float2 px;
    uint level;
    float rayZ;
    float sceneZ;
    float slabZ; // 0: never asked
    float distance;
    uint decision; // kSample*
};

GLINT_CONSTANT(uint, kLoggedRoughness, 0);
GLINT_CONSTANT(uint, kLoggedBorderSmooth, 1);
GLINT_CONSTANT(uint, kLoggedBorderLinear, 2);
GLINT_CONSTANT(uint, kLoggedDistance, 3);
GLINT_CONSTANT(uint, kLoggedIterations, 4);
GLINT_CONSTANT(uint, kLoggedFacingCamera, 5);
GLINT_CONSTANT(uint, kLoggedBackface, 6);
GLINT_CONSTANT(uint, kLoggedFadeCount, 7);

struct LoggedSource {
    uint answered; // 1: the fields below are set
    uint source;   // kSource*
    float weight;
    float3 radiance;
};

// trace/log/pixel.comp
struct LoggedPixel {
    uint2 px;    // that was asked for
    uint2 rayPX; // from which its ray starts
    uint outcome;
    uint2 record; // as the frame left it, lib/ray_record.glsl
    float viewZ;
    float3 positionVS;
    float3 positionWS;
    float3 normalWS;
    float3 f0;
    float perceptualRoughness;
    float4 reflected;
    float4 composite;
};

// trace/trace_main.glsl
struct LoggedRay {
    uint traced;   // 1: the fields below are set
    uint answered; // 1: so are radiance, weight and fades, and endPX is where they are from
    uint2 record;
    float3 startVS;
    float3 startWS;
    float3 directionVS;
    float3 directionWS;
    float lengthVS;
    float2 startPX;
    float2 endPX; // of the hit, or where the march ended
    float3 endVS;
    float3 endWS;
    float startZ;
    float endZ;
    float endDistance;
    float hitZ; // of the picture at the hit
    float3 radiance;
    float weight;
    uint lookups;
    uint iterations;
    uint fadesUsed; // a bit each
    float fades[kLoggedFadeCount];
    uint projected;           // 1: so are the next three, of march proxy
    uint probe;               // number in the host's list, or kNoProbe
    uint proxyShape;          // kProbe*
    float projectionDistance; // kBackgroundZ: infinite
};

struct RayLogHeader {
    LoggedPixel pixel;
    LoggedRay ray;
    LoggedSource sources[kSourceCount]; // in the order of the walk
    uint sampleCount;                   // those beyond kMaxLoggedSamples are counted, not written
};

GLINT_CONSTANT(uint, kMaxLoggedSamples, 4096);

struct InspectConstants {
    uint2 px;
};

GLINT_SHARED_END

#endif
