// Reflection probes, as shaders/probes reads them.
#ifndef GLINT_SHARED_PROBES_H
#define GLINT_SHARED_PROBES_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kProbeBox, 0); // ProbeShape; ProbeProxy without its None
GLINT_CONSTANT(uint, kProbeSphere, 1);
GLINT_CONSTANT(uint, kProbeNoProxy, 2);

GLINT_CONSTANT(uint, kNoProbe, 0xffffffffu); // no probe, in place of a probe's number

// Distances along the axes: `Pos` towards the positive faces, `Neg` towards the negative faces.
struct ProbeRecord {
    float4 worldToInfluence[3]; // rows of a rigid transform
    float4 worldToProxy[3];
    float3 influenceExtents; // half extents; a sphere's radius in x
    uint influenceShape;
    float3 proxyExtents;
    uint proxyShape;
    float3 blendPos; // > 0
    float weight;
    float3 blendNeg;
    float strength;
    float3 blendNormalPos;
    float lastMip; // the mip of roughness 1
    float3 blendNormalNeg;
    uint cube; // in the table of cubes
    float3 faceFadePos;
    float3 faceFadeNeg;
    float3 capturePositionWS;
    uint distances; // 1: the cube's alpha is 1 / metres to the surface it shows
};

// The header of the grid over all influence volumes; the cells follow. Cell c has the probes lists[cells[c]] up to, but
// not including, lists[cells[c + 1]], smallest volume first. Without probes all fields are 0.
struct ProbeGridHeader {
    float3 originWS;
    uint probeCount;
    float3 cellsPerMetre;
    uint3 size; // cells
};

struct ProbesConstants {
    uint flags;  // kProbes*; from kProbesStepsShift on: samples along a ray in cubes with distances; 0: proxies alone
    uint before; // bit s: source s (shared/hierarchy.h) is asked before this one
};

GLINT_CONSTANT(uint, kProbesParallax, 1);          // proxies apply
GLINT_CONSTANT(uint, kProbesDistanceRoughness, 2); // reflections of near surfaces are sharper

GLINT_CONSTANT(uint, kProbesStepsShift, 8);

GLINT_SHARED_END

#endif
