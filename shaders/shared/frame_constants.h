// The camera and the host's conventions for every pass of the library, already converted. Shaders use a right-handed
// view space looking down -Z, +Y up; viewZ is positive distance; UV (0,0) is top left.
#ifndef GLINT_SHARED_FRAME_CONSTANTS_H
#define GLINT_SHARED_FRAME_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

/// Where a host stores a scalar of its material: value = texel[channel] * scale + bias; scale 0: no image is read.
struct HostChannel {
    uint channel;
    float scale;
    float bias;
};

struct FrameConstants {
    float4x4 viewToPixel;        // homogeneous: (x, y, *, w) / w are pixels from the top left
    float4x4 worldToView;        // rigid
    float4x4 viewToWorld;        // rigid
    float4x4 worldToEnvironment; // rotates a direction into the environment cube's axes
    float4x4 viewToPrevView;     // rigid: this frame's view space to the previous one's
    float4x4 prevViewToPixel;    // as viewToPixel, of the previous frame
    float4 uvToView;             // positionVS.xy = (uv * xy + zw) * (perspective ? viewZ : 1)
    float4 prevUvToView;         // as uvToView, of the previous frame
    float4 depthToViewZ;         // viewZ = (ndc * x + y) / (ndc * z + w), ndc = depth * depthScale + depthOffset
    float2 size;                 // pixels in use, from the top left of the frame's images
    float2 invSize;
    float2 prevSize; // as size, of the previous frame
    float2 prevInvSize;
    float depthScale;
    float depthOffset;
    float farDepth; // device depth of the background
    float nearZ;    // metres: no surface is nearer
    uint flags;     // kInput*
    float environmentStrength;
    float environmentMips; // number of mips that roughness 0..1 spans
    uint frameIndex;
    uint seed;
    float2 traceSize;       // pixels of the traced image that this frame traces, from the top left
    float2 traceScale;      // size / traceSize: full-resolution pixels a traced pixel, >= 1
    float2 motionScale;     // stored motion times this = previous UV - current UV
    float motionDepthScale; // its third channel times this = previous viewZ - current viewZ; 0: there is none
    uint materialKind;      // kHostMaterial*, MaterialKind of glint/gbuffer.hpp
    HostChannel roughness;
    HostChannel metallic;
    HostChannel specular; // of dielectrics: F0 = 0.08 * value
    HostChannel occlusion;
    HostChannel f90; // of dielectrics, if the kind has metals
    HostChannel coat;
    HostChannel coatRoughness;
    uint historyExpected; // number of the frame that the history should hold
    uint historyTag;      // number of the frame that it holds: written by the GPU
};

GLINT_CONSTANT(uint, kInputOrthographic, 1);
GLINT_CONSTANT(uint, kInputLinearDepth, 2);   // depth * depthScale is viewZ in metres, 0 is background
GLINT_CONSTANT(uint, kInputReversedDepth, 4); // the background is at depth's small end
GLINT_CONSTANT(uint, kInputNormalView, 8);    // normals are in the host's view space
GLINT_CONSTANT(uint, kInputNormalOctahedral, 16);
GLINT_CONSTANT(uint, kInputNormalUnorm, 32);  // stored as n * 0.5 + 0.5
GLINT_CONSTANT(uint, kInputSmoothness, 64);   // the roughness channel holds 1 - perceptual roughness
GLINT_CONSTANT(uint, kInputLeftHanded, 128);  // the host's view space looks down +Z
GLINT_CONSTANT(uint, kInputEnvironment, 256); // an environment cube is bound
GLINT_CONSTANT(uint, kInputFallback, 512);    // a fallbackSpecular image is bound
GLINT_CONSTANT(uint, kInputMotion, 1024);     // a motion image is bound
GLINT_CONSTANT(uint, kInputHistory,
               2048);                         // hits take the previous frame's colour, if the GPU ran it: hasHistory
GLINT_CONSTANT(uint, kInputGamma, 4096);      // litRadiance and fallbackSpecular are sRGB-encoded
GLINT_CONSTANT(uint, kHistoryGamma, 8192);    // the previous frame's colour is sRGB-encoded
GLINT_CONSTANT(uint, kOutputGamma, 16384);    // this frame's output is sRGB-encoded
GLINT_CONSTANT(uint, kTraceTarget8, 32768);   // the traced radiance goes into the RGBA8 image
GLINT_CONSTANT(uint, kInputHalfDepth, 65536); // viewZ is rounded to sixteen bits
GLINT_CONSTANT(uint, kInputMaterial, 131072); // a material image is bound

GLINT_CONSTANT(uint, kInputResolved, 262144); // read the material as prepare resolved it: F0 and coverage

// Hits exclude highlights: litRadiance's alpha is the mean of its linear channels without highlights.
GLINT_CONSTANT(uint, kInputHighlights, 524288);

GLINT_CONSTANT(uint, kInputAlpha, 1048576);     // the roughness channel holds alpha, perceptual roughness squared
GLINT_CONSTANT(uint, kInputOcclusion, 2097152); // the host states ambient occlusion
GLINT_CONSTANT(uint, kInputSamples, 4194304);   // the host has several samples a pixel
GLINT_CONSTANT(uint, kInputF90, 8388608);       // the host states F90
GLINT_CONSTANT(uint, kInputCoat, 16777216);     // the host states a clear coat
GLINT_CONSTANT(uint, kInputCoatNormal, 33554432);
GLINT_CONSTANT(uint, kLobeCoat, 67108864);       // the passes' surface is the coat: its rays, answers and means
GLINT_CONSTANT(uint, kInputPrevious, 134217728); // the previous frame's picture is bound: hasPrevious

GLINT_CONSTANT(uint, kHostMaterialF0Roughness, 0);
GLINT_CONSTANT(uint, kHostMaterialMetallicRoughness, 1);
GLINT_CONSTANT(uint, kHostMaterialSpecularGlossiness, 2);
GLINT_CONSTANT(uint, kHostMaterialStandard, 3);

GLINT_CONSTANT(float, kBackgroundZ, 1.0e30f); // viewZ of pixels that show no surface

GLINT_SHARED_END

#endif
