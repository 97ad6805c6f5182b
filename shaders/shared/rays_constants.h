// Settings of the source `rays` for its shaders.
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
    uint lightsTogether; ///< so many share a shadow ray on paths that the denoiser averages
    float reuseRoughness;
    uint before;            ///< bit s: source s (shared/hierarchy.h) is asked before this one
    float regularization;   ///< of a mean's first sample
    float interpolate;      ///< largest difference of rays that answer for pixels between them; 0: each pixel sends one
    uint instancesBefore;   ///< instances that the previous frame had; 0: nobody asks what moved
    uint transparents;      ///< most transparent surfaces in a path
    float3 transparentsLow; ///< world box of all transparent surfaces
    float3 transparentsHigh;
};

GLINT_CONSTANT(uint, kRaysAlphaTest, 1);               // texels may let a ray pass
GLINT_CONSTANT(uint, kRaysMirror, 2);                  // mirror directions only, at any roughness
GLINT_CONSTANT(uint, kRaysEnvironment, 4);             // the environment answers for a ray that misses
GLINT_CONSTANT(uint, kRaysEnvironmentDiffuse, 8);      // the host's own diffuse environment is bound
GLINT_CONSTANT(uint, kRaysAccumulate, 16);             // previous frames of the same view count as well
GLINT_CONSTANT(uint, kRaysReuseLight, 32);             // of surfaces that the frame shows
GLINT_CONSTANT(uint, kRaysTransparentScene, 128);      // some materials are transparent, however rays treat them
GLINT_CONSTANT(uint, kRaysTransparents, 64);           // some surfaces let rays pass
GLINT_CONSTANT(uint, kRaysSampleLights, 256);          // rays to lights wherever a path continues from
GLINT_CONSTANT(uint, kRaysSampleSky, 512);             // to the environment alone, from what the denoiser averages
GLINT_CONSTANT(uint, kRaysEnvironmentOcclusion, 1024); // a last ray tells if the last surface's environment is hidden

GLINT_CONSTANT(uint, kRaysBranches, 2048);     // what mirrors show is stored in two parts: lib/mirrored.glsl
GLINT_CONSTANT(uint, kRaysPreviousEnds, 4096); // paths may end in the previous frame's picture
GLINT_CONSTANT(uint, kRaysCone, 8192);         // with kRaysMirror: a mirror ray stands for the whole lobe

// Smoother lobes find every light that they can reflect: perceptual.
GLINT_CONSTANT(float, kSmoothestSampled, 0.05f);

// Fourth word of the source's record: where the first hit was in the previous frame, lib/packed_motion.glsl. Third
// word, after the words of lib/ray_record.glsl: number of hits lit from the frame (low 12 bits), and
GLINT_CONSTANT(uint, kRaysReusedMask, 0xfff);
GLINT_CONSTANT(uint, kRaysLightsOnly, 0x08000000);     // from rays/list: no path is needed, but rays to lights are
GLINT_CONSTANT(uint, kRaysSkyApart, 0x10000000);       // mirroredLight's exact part is light of the environment
GLINT_CONSTANT(uint, kRaysBranched, 0x20000000);       // the answer is stored in two parts, too
GLINT_CONSTANT(uint, kRaysStartOnScreen, 0x40000000);  // the first hit is the screen's hit
GLINT_CONSTANT(uint, kRaysReplaceScreen, 0x80000000u); // the answer replaces the screen's too

GLINT_SHARED_END

#endif
