// Flags of a ray (lib/ray.glsl), and flags and masks of an instance's triangles.
#ifndef GLINT_SHARED_RAY_FLAGS_H
#define GLINT_SHARED_RAY_FLAGS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kRayCullBackFaces, 1u); ///< pass through back faces of instances that are not double-sided
GLINT_CONSTANT(uint, kRayAllOpaque, 2u);     ///< every triangle stops the ray: no test for holes

// Masks of our own renderer's instances: shadow rays exclude transparent surfaces.
GLINT_CONSTANT(uint, kTransparentMask, 0x80u);
GLINT_CONSTANT(uint, kShadowMask, 0x7fu);

GLINT_CONSTANT(uint, kNoInstance, 0xffffffffu); ///< Hit::instance of a miss

GLINT_SHARED_END

#endif
