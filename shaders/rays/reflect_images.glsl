// What rays/reflect reads of earlier frames and passes, and what it stores.
#ifndef GLINT_RAYS_REFLECT_IMAGES_GLSL
#define GLINT_RAYS_REFLECT_IMAGES_GLSL

layout(set = 0, binding = 7, rgba16f) uniform writeonly image2D raysRadianceWeight;
layout(set = 0, binding = 8, rgba32ui) uniform uimage2D raysRecord;
layout(set = 0, binding = 11, rgba32f) uniform image2D raysSum;  // all samples: weighted radiance, known weight
layout(set = 0, binding = 12, r32f) uniform image2D raysWeights; // all samples: weight (both: kRaysAccumulate)
layout(set = 0, binding = 27) uniform sampler2D metaBefore; // denoise/accumulate.comp's; one black texel without
// lib/mirrored.glsl, where the record says kRaysBranched or kRaysSkyApart; one texel each without either flag.
layout(set = 0, binding = 28, rgba32ui) uniform writeonly uimage2D mirroredSurface;
layout(set = 0, binding = 29, rgba32ui) uniform writeonly uimage2D mirroredLight;

#endif
