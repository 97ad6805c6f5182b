// Includes the back end of the ray seam (lib/ray.glsl) that the variant selects: shaders/variants.txt.
#ifndef GLINT_RAYS_BACK_END_GLSL
#define GLINT_RAYS_BACK_END_GLSL

#if defined(GLINT_RAYS_BVH)
#include "rays/bvh.glsl"
#elif defined(GLINT_RAYS_QUERY)
#include "rays/query.glsl"
#else
#error no back end: GLINT_RAYS_BVH or GLINT_RAYS_QUERY
#endif

#endif
