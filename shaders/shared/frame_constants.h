// What every pass of the library knows of the camera and of the host's conventions, already converted: shaders see
// right-handed view space looking down -Z, +Y up, viewZ as positive distance, UV (0,0) top left.
#ifndef GLINT_SHARED_FRAME_CONSTANTS_H
#define GLINT_SHARED_FRAME_CONSTANTS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct FrameConstants {
    float4x4 viewToPixel;        // homogeneous: (x, y, *, w) / w are pixels from the top left
    float4x4 worldToView;        // rigid
    float4x4 viewToWorld;        // rigid
    float4x4 worldToEnvironment; // turns a direction into the environment cube's axes
    float4 uvToView;             // positionVS.xy = (uv * xy + zw) * (perspective ? viewZ : 1)
    float4 depthToViewZ;         // viewZ = (ndc * x + y) / (ndc * z + w), ndc = depth * depthScale + depthOffset
    float2 size;                 // pixels
    float2 invSize;
    float depthScale;
    float depthOffset;
    float farDepth;        // device depth of the background
    float nearZ;           // metres: nothing nearer is drawn
    uint flags;            // kInput*
    uint roughnessChannel; // of the material image
    float environmentStrength;
    float environmentMips; // mips that roughness 0..1 spreads over
    uint frameIndex;
    uint seed;
    uint metallicChannel; // of the material image
    uint materialKind;    // kMaterial*, MaterialKind of glint/gbuffer.hpp
};

GLINT_CONSTANT(uint, kInputOrthographic, 1);
GLINT_CONSTANT(uint, kInputLinearDepth, 2);   // depth is viewZ in metres already, 0 is background
GLINT_CONSTANT(uint, kInputReversedDepth, 4); // the background is at the small end
GLINT_CONSTANT(uint, kInputNormalView, 8);    // normals are in the host's view space
GLINT_CONSTANT(uint, kInputNormalOctahedral, 16);
GLINT_CONSTANT(uint, kInputNormalUnorm, 32);  // stored as n * 0.5 + 0.5
GLINT_CONSTANT(uint, kInputSmoothness, 64);   // the roughness channel holds 1 - perceptualRoughness
GLINT_CONSTANT(uint, kInputLeftHanded, 128);  // the host's view space looks down +Z
GLINT_CONSTANT(uint, kInputEnvironment, 256); // an environment cube is there
GLINT_CONSTANT(uint, kInputFallback, 512);    // a fallbackSpecular image is there
GLINT_CONSTANT(uint, kInputHalfDepth, 1024);  // viewZ is rounded to sixteen bits
GLINT_CONSTANT(uint, kInputMaterial, 2048);   // a material image is there

GLINT_CONSTANT(uint, kMaterialF0Roughness, 0);
GLINT_CONSTANT(uint, kMaterialMetallicRoughness, 1);
GLINT_CONSTANT(uint, kMaterialSpecularGlossiness, 2);
GLINT_CONSTANT(uint, kMaterialStandard, 3);

GLINT_CONSTANT(float, kBackgroundZ, 1.0e30f); // viewZ of pixels that show no surface

GLINT_SHARED_END

#endif
