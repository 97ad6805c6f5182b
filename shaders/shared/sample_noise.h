// The mask of the noise for directions (generate/sample_noise.glsl).
#ifndef GLINT_SHARED_SAMPLE_NOISE_H
#define GLINT_SHARED_SAMPLE_NOISE_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kBlueNoiseSize, 64); // texels a side

GLINT_SHARED_END

#endif
