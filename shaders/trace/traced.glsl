// Where a marcher stores its answer.
#ifndef GLINT_TRACE_TRACED_GLSL
#define GLINT_TRACE_TRACED_GLSL

#include "frame/frame_block.glsl"
#include "lib/color.glsl"
#include "lib/ray_record.glsl"

// Radiance, not multiplied by weight. screen.targetFormat selects one of the two images; the other is a single texel.
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D radianceWeight;
layout(set = 0, binding = 9, rgba8) uniform writeonly image2D radianceWeight8;
layout(set = 0, binding = 5, rg32ui) uniform writeonly uimage2D rayRecord;

void storeTraced(ivec2 tracePX, vec3 radiance, float weight, RayRecord record) {
    if ((frame.constants.flags & kTraceTarget8) != 0u)
        imageStore(radianceWeight8, tracePX, vec4(scaledToOne(radiance), weight));
    else
        imageStore(radianceWeight, tracePX, vec4(radiance, weight));
    imageStore(rayRecord, tracePX, uvec4(packRayRecord(record), 0u, 0u));
}

#endif
