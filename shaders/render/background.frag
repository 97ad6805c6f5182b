// The environment, and the sun's disc, where no surface is; and how the background moves when the camera turns.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "lib/environment.glsl"
#include "shared/render_view.h"

layout(scalar, set = 0, binding = 0) uniform ViewBlock {
    RenderView constants;
} view;
layout(set = 0, binding = 1) uniform samplerCube environmentRadiance;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec2 outMotion;
layout(location = 1) out vec4 outLitRadiance;

vec3 viewRay() {
    if (view.constants.orthographic != 0u)
        return view.constants.cameraForwardWS;
    vec4 nearWS = view.constants.clipToWorld * vec4(ndc, 1.0, 1.0);
    return normalize(nearWS.xyz / nearWS.w - view.constants.cameraPositionWS);
}

vec3 backgroundRadiance(vec3 directionWS) {
    if (view.constants.environmentVisible == 0u)
        return vec3(0.0);
    vec3 turned = rotateToEnvironment(directionWS, view.constants.environmentRotation);
    vec3 radiance = textureLod(environmentRadiance, turned, 0.0).rgb * view.constants.environmentStrength;
    if (dot(directionWS, view.constants.sunDirWS) > view.constants.sunCosRadius)
        radiance += view.constants.sunRadiance;
    return min(radiance, vec3(65000.0)); // the end of half floats
}

void main() {
    vec3 directionWS = viewRay();
    outLitRadiance = vec4(backgroundRadiance(directionWS), 0.0);
    // Infinitely far: only turning moves it, so the direction is projected as a point at infinity.
    vec4 previousCS = view.constants.prevWorldToClip * vec4(directionWS, 0.0);
    outMotion = vec2(0.0);
    if (view.constants.orthographic == 0u && previousCS.w > 0.0) {
        vec2 previousUV = previousCS.xy / previousCS.w * vec2(0.5, -0.5) + 0.5 - view.constants.prevJitterUV;
        outMotion = previousUV - (ndc * vec2(0.5, -0.5) + 0.5 - view.constants.jitterUV);
    }
}
