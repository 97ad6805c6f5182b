// Refraction as shaders/refraction and glint/transparent_layer.hpp have it.
#ifndef GLINT_SHARED_REFRACTION_H
#define GLINT_SHARED_REFRACTION_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kRefractionStraight, 0); // BodyShape of glint/transparent_layer.hpp
GLINT_CONSTANT(uint, kRefractionSphere, 1);
GLINT_CONSTANT(uint, kRefractionPlane, 2);
GLINT_CONSTANT(uint, kRefractionThin, 3);
GLINT_CONSTANT(float, kThinWall, 0.005f); // metres: HDRP's

// Pushed behind TraceConstants. Overrides are the settings refraction.*; below 0: the host's own.
struct RefractionConstants {
    float ior; // 0: the host's own
    float thickness;
    float thicknessMultiplier;
    float absorptionDistance;
    uint2 transmittance; // four halves: a colour, and 1 if it overrides
    uint flags;          // kLayer*
    uint probeFlags;     // kProbes*
    float strength;      // of reflections
    float reflectionBorderWidth;
};

GLINT_CONSTANT(uint, kLayerModelMask, 7); // one more than the kRefraction* that overrides; 0: the host's own
GLINT_CONSTANT(uint, kLayerProxy, 8);     // refraction.projection
GLINT_CONSTANT(uint, kLayerReflects, 16);
GLINT_CONSTANT(uint, kLayerScreen, 32); // sources that take part
GLINT_CONSTANT(uint, kLayerProbes, 64);
GLINT_CONSTANT(uint, kLayerSky, 128);
GLINT_CONSTANT(uint, kLayerFallback, 256); // images that are there
GLINT_CONSTANT(uint, kLayerCenters, 512);
GLINT_CONSTANT(uint, kLayerCoverage, 1024);
GLINT_CONSTANT(uint, kLayerViews, 2048); // keep what views show

GLINT_SHARED_END

#endif
