// The log of one pixel's ray during inspection; include/glint/inspection.hpp documents each field.
#ifndef GLINT_SHARED_RAY_LOG_H
#define GLINT_SHARED_RAY_LOG_H

#include "shared/hierarchy.h"
#include "shared/types.h"

GLINT_SHARED_BEGIN

// The decision about one depth sample. src/reflect/inspect/inspector.cpp has their names.
GLINT_CONSTANT(uint, kSampleFront, 0);    // the ray is in front of every surface there
GLINT_CONSTANT(uint, kSampleBehind, 1);   // behind it; no further test was made
GLINT_CONSTANT(uint, kSampleEmpty, 2);    // a cell that shows no surface
GLINT_CONSTANT(uint, kSampleLookInto, 3); // a cell to descend into
GLINT_CONSTANT(uint, kSamplePasses, 4);   // no hit, though the ray is neither in front nor behind
GLINT_CONSTANT(uint, kSampleHit, 5);
GLINT_CONSTANT(uint, kSampleSide, 6);
GLINT_CONSTANT(uint, kSampleBackFace, 7);
GLINT_CONSTANT(uint, kSampleGrazes, 8);
GLINT_CONSTANT(uint, kSampleNearly, 9);
GLINT_CONSTANT(uint, kSamplePlaces, 10);   // the neighbour that contains the hit's exact place
GLINT_CONSTANT(uint, kSampleInferred, 11); // a surface was crossed there, behind the occluder that the pixel shows
GLINT_CONSTANT(uint, kSampleBeside, 12);   // read only to see whether that surface shows beside the occluder
GLINT_CONSTANT(uint, kSampleDecisionCount, 13);

struct LoggedSample {
    float2 px;
    uint level;
    float rayZ;
    float sceneZ;
    float slabZ; // 0: not sampled
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
GLINT_CONSTANT(uint, kLoggedInferred, 7);
GLINT_CONSTANT(uint, kLoggedUncertain, 8);
GLINT_CONSTANT(uint, kLoggedFadeCount, 9);

struct LoggedSource {
    uint answered; // 1: the fields below are set
    uint source;   // kSource*
    float weight;
    float3 radiance;
};

// trace/log/pixel.comp
struct LoggedPixel {
    uint2 px;    // the pixel to inspect
    uint2 rayPX; // the pixel that its ray starts from
    uint outcome;
    uint2 record; // as the frame stored it, lib/ray_record.glsl
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
    uint answered; // 1: radiance, weight and fades are set too, and endPX is where they come from
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
    float hitZ; // of the frame's surface at the hit
    float3 radiance;
    float weight;
    uint lookups;
    uint iterations;
    uint fadesUsed; // one bit each
    float fades[kLoggedFadeCount];
    uint projected;           // 1: the next three are set too, by march proxy
    uint probe;               // number in the host's list, or kNoProbe
    uint proxyShape;          // kProbe*
    float projectionDistance; // kBackgroundZ: infinite
};

struct RayLogHeader {
    LoggedPixel pixel;
    LoggedRay ray;
    LoggedSource sources[kMaxSources]; // in the order in which they are asked
    uint sampleCount;                  // samples beyond kMaxLoggedSamples are counted, not written
};

GLINT_CONSTANT(uint, kMaxLoggedSamples, 4096);

struct InspectConstants {
    uint2 px;
};

GLINT_SHARED_END

#endif
