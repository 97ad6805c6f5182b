// Push constants of the passes that prepare an environment for lighting.
#ifndef GLINT_SHARED_ENVIRONMENT_H
#define GLINT_SHARED_ENVIRONMENT_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

struct PrefilterConstants {
    uint faceSize; ///< texels, of the target mip
    uint sampleCount;
    float perceptualRoughness; ///< of the target mip
    float sourceFaceSize;      ///< texels
};

struct FaceConstants {
    uint face;  ///< of the cube, in Vulkan's order
    float near; ///< of the camera: depth = near / viewZ, 0 for the sky
};

GLINT_SHARED_END
#endif
