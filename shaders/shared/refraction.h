// Refraction, for shaders/refraction and glint/transparent_layer.hpp.
#ifndef GLINT_SHARED_REFRACTION_H
#define GLINT_SHARED_REFRACTION_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kRefractionStraight, 0); // BodyShape of glint/transparent_layer.hpp
GLINT_CONSTANT(uint, kRefractionSphere, 1);
GLINT_CONSTANT(uint, kRefractionPlane, 2);
GLINT_CONSTANT(uint, kRefractionThin, 3);
GLINT_CONSTANT(float, kThinWall, 0.005f); // metres, as in HDRP

// Overrides are the settings refraction.*; a value below 0 keeps the host's own.
struct RefractionConstants {
    float ior; // 0: the host's own
    float thickness;
    float thicknessMultiplier;
    float absorptionDistance;
    uint2 transmittance; // three halves: the colour that overrides; below 0: the material's
    uint flags;          // kLayer*
    uint probeFlags;     // kProbes*
    float reflectionBorderWidth;
    float dispersion; // 20 / Abbe number
    uint innerReflections;
};

GLINT_CONSTANT(uint, kLayerModelMask, 7); // 1 + the kRefraction* that overrides; 0: the host's own
GLINT_CONSTANT(uint, kLayerProxy, 8);     // refraction.projection
GLINT_CONSTANT(uint, kLayerReflects, 16);
GLINT_CONSTANT(uint, kLayerScreen, 32); // enabled sources
GLINT_CONSTANT(uint, kLayerProbes, 64);
GLINT_CONSTANT(uint, kLayerSky, 128);
GLINT_CONSTANT(uint, kLayerFallback, 256); // bound images: a push constant
GLINT_CONSTANT(uint, kLayerCenters, 512);
GLINT_CONSTANT(uint, kLayerCoverage, 1024);
GLINT_CONSTANT(uint, kLayerViews, 2048); // store what views show

GLINT_SHARED_END

#endif
