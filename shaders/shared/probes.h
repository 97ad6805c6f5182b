// Reflection probes as shaders/probes reads them.
#ifndef GLINT_SHARED_PROBES_H
#define GLINT_SHARED_PROBES_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kProbeBox, 0); // ProbeShape, ProbeProxy less its None
GLINT_CONSTANT(uint, kProbeSphere, 1);
GLINT_CONSTANT(uint, kProbeNoProxy, 2);

GLINT_CONSTANT(uint, kNoProbe, 0xffffffffu); // in place of one's number

// Of distances along the axes `Pos` are towards the positive faces, `Neg` the negative ones.
struct ProbeRecord {
    float4 worldToInfluence[3]; // rows of a rigid transform
    float4 worldToProxy[3];
    float3 influenceExtents; // half; a sphere's radius in x
    uint influenceShape;
    float3 proxyExtents;
    uint proxyShape;
    float3 blendPos; // > 0
    float weight;
    float3 blendNeg;
    float strength;
    float3 blendNormalPos;
    float lastMip; // that of roughness 1
    float3 blendNormalNeg;
    uint cube; // in the table of cubes
    float3 faceFadePos;
    float3 faceFadeNeg;
    float3 capturePositionWS;
    uint distances; // 1: the cube's alpha is 1 / metres to what it shows
};

// The grid over all influence volumes, in front of its cells: cell c has the probes lists[cells[c]] up to, not with,
// lists[cells[c + 1]], smallest volume first. Without probes all of it is 0.
struct ProbeGridHeader {
    float3 originWS;
    uint probeCount;
    float3 cellsPerMetre;
    uint3 size; // cells
};

struct ProbesConstants {
    uint flags;  // kProbes*, and from kProbesStepsShift on looks along a ray in cubes with distances; 0: proxies alone
    uint before; // bit s: source s (shared/hierarchy.h) is asked before
};

GLINT_CONSTANT(uint, kProbesParallax, 1);          // proxies act
GLINT_CONSTANT(uint, kProbesDistanceRoughness, 2); // what is near its reflection is sharper

GLINT_CONSTANT(uint, kProbesStepsShift, 8);

GLINT_SHARED_END

#endif
