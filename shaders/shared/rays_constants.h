// Settings of the source `rays` as its shaders take them.
#ifndef GLINT_SHARED_RAYS_CONSTANTS_H
#define GLINT_SHARED_RAYS_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct RaysConstants {
    uint samples;
    uint bounces;
    float tMin; ///< metres; 0: the start is moved off its surface instead
    float tMax;
    float maxRoughness;
    float threshold; ///< as TraceConstants::threshold
    uint flags;      ///< kRays...
    uint cullMask;
    uint lightCount;
    float reuseRoughness;
    uint before; ///< bit s: source s (shared/hierarchy.h) is asked before
};

GLINT_CONSTANT(uint, kRaysAlphaTest, 1);          // texels may let a ray through
GLINT_CONSTANT(uint, kRaysMirror, 2);             // mirror directions only, whatever the roughness
GLINT_CONSTANT(uint, kRaysEnvironment, 4);        // the environment answers where a ray meets nothing
GLINT_CONSTANT(uint, kRaysEnvironmentDiffuse, 8); // the host's own diffuse light is there
GLINT_CONSTANT(uint, kRaysAccumulate, 16);        // the frames before, of the same view, count as well
GLINT_CONSTANT(uint, kRaysReuseLight, 32);        // of surfaces that the picture shows

// Third word of the source's record, behind those of lib/ray_record.glsl: hits whose light was the picture's (low 12
// bits), and
GLINT_CONSTANT(uint, kRaysReusedMask, 0xfff);
GLINT_CONSTANT(uint, kRaysStartOnScreen, 0x40000000);  // the first hit is the screen's
GLINT_CONSTANT(uint, kRaysReplaceScreen, 0x80000000u); // the answer stands for the screen's too

GLINT_CONSTANT(uint, kBlueNoiseSize, 64); // texels a side of the mask

GLINT_SHARED_END

#endif
