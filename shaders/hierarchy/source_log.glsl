// Logs each source's answer for the inspected pixel; empty unless GLINT_RAY_LOG is defined.
#ifndef GLINT_HIERARCHY_SOURCE_LOG_GLSL
#define GLINT_HIERARCHY_SOURCE_LOG_GLSL

#include "shared/ray_log.h"

#ifdef GLINT_RAY_LOG

layout(scalar, set = 0, binding = 13) buffer LogBlock {
    RayLogHeader header;
} rayLog;

/// `place`: in the order of sources.
void logSource(ivec2 px, uint place, uint source, float weight, vec3 radiance) {
    if (px == ivec2(rayLog.header.pixel.px))
        rayLog.header.sources[place] = LoggedSource(1u, source, weight, radiance);
}

#else

void logSource(ivec2 px, uint place, uint source, float weight, vec3 radiance) {}

#endif
#endif
