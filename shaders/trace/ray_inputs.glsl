// What every marcher reads and writes, and its settings.
#ifndef GLINT_TRACE_RAY_INPUTS_GLSL
#define GLINT_TRACE_RAY_INPUTS_GLSL

#include "frame/prepared.glsl"
#include "lib/screen_ray.glsl"
#include "lib/surface.glsl"
#include "shared/outcome.h"
#include "shared/trace_constants.h"
#include "trace/met_surface.glsl"

layout(set = 0, binding = 11) uniform sampler2D backViewZ; // with kTraceBackInPlace the host's depth
#ifdef GLINT_REFRACTION
TraceConstants settings = frame.settings.layerTrace;
#else
TraceConstants settings = frame.settings.trace;
#endif

bool isOn(uint flag) {
    return (settings.flags & flag) != 0u;
}

bool onScreen(vec2 px) {
    return all(greaterThanEqual(px, vec2(0.0))) && all(lessThan(px, frame.constants.size));
}

/// A ray to be marched.
struct Ray {
    ScreenRay screen;
    vec3 originVS;
    vec3 originNormalVS;
    vec3 directionVS; // unit
    ivec2 px;         // the pixel where it starts
};

/// How a march ended.
struct March {
    float share; // fraction of the ray's line on screen
    vec2 hitPX;  // of a hit
    uint iterations;
    uint lookups; // reads of any depth image
    uint outcome;
};

#include "trace/ray_log.glsl"

#endif
