// Where a marcher stores its answer.
#ifndef GLINT_TRACE_TRACED_GLSL
#define GLINT_TRACE_TRACED_GLSL

#include "frame/frame_block.glsl"
#include "lib/color.glsl"
#include "lib/ray_record.glsl"

// Radiance, not multiplied by weight. screen.targetFormat selects one of the two images; the other is a single texel.
#ifdef GLINT_READ_TRACED
#define GLINT_TRACED_ACCESS
#else
#define GLINT_TRACED_ACCESS writeonly
#endif
layout(set = 0, binding = 4, rgba16f) uniform GLINT_TRACED_ACCESS image2D radianceWeight;
layout(set = 0, binding = 9, rgba8) uniform GLINT_TRACED_ACCESS image2D radianceWeight8;
// If kTraceRecords.
layout(set = 0, binding = 5, rg32ui) uniform GLINT_TRACED_ACCESS uimage2D rayRecord;

#ifdef GLINT_READ_TRACED
vec4 loadTraced(ivec2 tracePX) {
    bool eightBits = (frame.constants.flags & kTraceTarget8) != 0u;
    return eightBits ? imageLoad(radianceWeight8, tracePX) : imageLoad(radianceWeight, tracePX);
}
#endif

void storeTraced(ivec2 tracePX, vec3 radiance, float weight, RayRecord record) {
    if ((frame.constants.flags & kTraceTarget8) != 0u)
        imageStore(radianceWeight8, tracePX, vec4(scaledToOne(radiance), weight));
    else
        imageStore(radianceWeight, tracePX, vec4(radiance, weight));
    if ((frame.settings.trace.flags & kTraceRecords) != 0u)
        imageStore(rayRecord, tracePX, uvec4(packRayRecord(record), 0u, 0u));
}

#endif
