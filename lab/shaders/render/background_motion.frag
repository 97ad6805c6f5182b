// Motion of the background when the camera rotates.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "render/background_ray.glsl"

layout(location = 0) out vec4 outMotion;

void main() {
    // The background is infinitely far and moves by rotation only, so its direction is projected as a point at
    // infinity.
    vec4 previousCS = view.constants.prevWorldToClip * vec4(viewRay(), 0.0);
    outMotion = vec4(0.0);
    if (view.constants.orthographic == 0u && previousCS.w > 0.0) {
        vec2 previousUV = previousCS.xy / previousCS.w * vec2(0.5, -0.5) + 0.5 - view.constants.prevJitterUV;
        outMotion.xy = previousUV - (ndc * vec2(0.5, -0.5) + 0.5 - view.constants.jitterUV);
    }
}
