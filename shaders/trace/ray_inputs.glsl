// What the frame's rays march through, and their settings: the seam of trace/ray.glsl, for trace/trace_main.glsl.
#ifndef GLINT_TRACE_RAY_INPUTS_GLSL
#define GLINT_TRACE_RAY_INPUTS_GLSL

#include "frame/prepared.glsl"
#include "lib/back_face.glsl"
#include "lib/surface.glsl"
#include "shared/trace_constants.h"
#include "trace/met_surface.glsl"

layout(set = 0, binding = 11) uniform sampler2D backViewZ; // with kTraceBackInPlace the host's depth
TraceConstants settings = frame.settings.trace;

#include "trace/ray.glsl"

float loadSceneZ(ivec2 px) {
    return texelFetch(metViewZ, px, 0).r;
}

vec3 loadSceneNormalVS(ivec2 px) {
    return unpackSurface(texelFetch(metSurface, px, 0).xy).normalVS;
}

float loadSceneBackZ(ivec2 px, float sceneZ) {
    float backZ = texelFetch(backViewZ, px, 0).r;
    if (!kAmongTransparents && isOn(kTraceBackInPlace))
        backZ = storedViewZ(frame.constants, backViewZOf(frame.constants, backZ, sceneZ));
    return backZ;
}

#endif
