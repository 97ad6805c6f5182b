// Planar mirrors, as shaders/planar reads them.
#ifndef GLINT_SHARED_PLANAR_H
#define GLINT_SHARED_PLANAR_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

// In the view space of the frame. The mirror's images are entries 2 * picture and 2 * picture + 1 of the table:
// radiance with mips, and viewZ, both as if the world behind the mirror were seen through it.
struct PlanarRecord {
    float3 centerVS;
    float tolerance; // metres from the plane
    float3 normalVS;
    uint picture;
    float3 tangentVS;
    float halfWidth; // along the tangent
    float3 bitangentVS;
    float halfHeight;
    float2 size; // pixels of the images
    float lastMip;
    uint padding;
};

struct PlanarConstants {
    uint before; // bit s: source s (shared/hierarchy.h) is asked before this one
    uint steps;
    float roughnessFadeStart;
    float maxRoughness;
    float borderWidth; // UV
};

GLINT_CONSTANT(uint, kMaxPlanarRecords, 16);

GLINT_SHARED_END

#endif
