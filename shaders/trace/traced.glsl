// Where a marcher leaves its answer. Include after `frame`.
#ifndef GLINT_TRACE_TRACED_GLSL
#define GLINT_TRACE_TRACED_GLSL

#include "lib/ray_record.glsl"
#include "shared/frame_constants.h"

// Radiance, not multiplied by weight. One of the two is real (screen.targetFormat), the other one texel.
layout(set = 0, binding = 4, rgba16f) uniform writeonly image2D radianceWeight;
layout(set = 0, binding = 9, rgba8) uniform writeonly image2D radianceWeight8;
layout(set = 0, binding = 5, rg32ui) uniform writeonly uimage2D rayRecord;

void storeTraced(ivec2 tracePX, vec3 radiance, float weight, RayRecord record) {
    if ((frame.constants.flags & kTraceTarget8) != 0u)
        imageStore(radianceWeight8, tracePX, vec4(radiance, weight));
    else
        imageStore(radianceWeight, tracePX, vec4(radiance, weight));
    imageStore(rayRecord, tracePX, uvec4(packRayRecord(record), 0u, 0u));
}

#endif
