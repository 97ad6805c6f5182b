// What a ray may ask for (lib/ray.glsl) and what an instance says about its triangles.
#ifndef GLINT_SHARED_RAY_FLAGS_H
#define GLINT_SHARED_RAY_FLAGS_H

#include "shared/types.h"

GLINT_SHARED_BEGIN

GLINT_CONSTANT(uint, kRayCullBackFaces, 1u); ///< pass through back faces of instances that are not double-sided
GLINT_CONSTANT(uint, kRayAllOpaque, 2u);     ///< every triangle stops the ray: nobody is asked about holes

GLINT_CONSTANT(uint, kNoInstance, 0xffffffffu); ///< Hit::instance of a miss

GLINT_SHARED_END

#endif
